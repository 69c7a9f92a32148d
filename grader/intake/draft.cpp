// STAFF ONLY. Collects a submission's files, checks its limits, and keeps submissions of the same name apart.
#include "grader/intake/draft.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "grader/intake/names/names.h"
#include "grader/intake/submission.h"
#include "grader/text/letters.h"

namespace grader::inline intake {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return std::accumulate(
      words.begin(), words.end(), std::string(),
      [](const std::string& text, const auto& word) { return text + (text.empty() ? "" : ", ") + word; });
}

bool comes_before(const Draft& a, const Draft& b) {
  return std::tie(a.submission.name, a.path) < std::tie(b.submission.name, b.path);
}

// Marks a draft that has the same name as another one.
void mark(Draft& draft, const std::string& name, const Draft& other) {
  const std::string both = " are both the submission \"" + name + "\"";
  draft.submission.origin.clear();  // its name is made of a path, not of a student
  draft.refuse(Refused(draft.shown + " and " + other.shown + both +
                       ", so this one was not graded. One of them needs another name."));
  draft.notices.push_back(draft.origin + " and " + other.origin + both +
                          "; rename one of them. This one is \"" + draft.submission.name +
                          "\" for now, and not graded");
}

}  // namespace

void IntakeBudget::charge_entries(std::size_t count) {
  entries_ += count;
  if (entries_ > limits_.entries) {
    throw Refused("More than " + std::to_string(limits_.entries) +
                  " files and folders were handed in. Hand in only the exercise files.");
  }
}

void IntakeBudget::charge_bytes(std::uintmax_t bytes) {
  if (bytes > bytes_left_) {
    throw Refused("What was handed in unpacks to more than " + shown_size(limits_.unpacked_bytes) +
                  ". Hand in only the exercise files.");
  }
  bytes_left_ -= static_cast<std::size_t>(bytes);
}

void Draft::refuse(const Refused& why) {
  const auto* unreadable = dynamic_cast<const Unreadable*>(&why);
  submission.files.clear();
  submission.problem = why.what();
  submission.unreadable = unreadable != nullptr;
  if (unreadable != nullptr && !unreadable->failure().empty())
    remarks.push_back(origin + ": " + unreadable->failure());
}

void Draft::offer(const std::string& exercise_file, const Found& where, SourceFile file) {
  const auto [at, is_first] = found.try_emplace(exercise_file, Choice{where});
  auto& [taken, rival] = at->second;
  SourceFile& source = submission.files[exercise_file];
  const bool same = source.text == file.text && source.problem.empty() && file.problem.empty();
  if (is_first) {
    source = std::move(file);
  } else if (where.rank() < taken.rank()) {
    pass_over(exercise_file, taken.shown);
    at->second = {where};
    source = std::move(file);
  } else if (where.rank() > taken.rank()) {
    pass_over(exercise_file, where.shown);
  } else if (!same && rival.empty()) {
    rival = where.shown;
  }
}

void Draft::pass_over(const std::string& exercise_file, const std::string& where, std::size_t count) {
  PassedOver& passed = passed_over[exercise_file];
  if (passed.count == 0) passed.first = where;
  passed.count += count;
}

void Draft::see(std::string_view name) {
  constexpr std::size_t kMost = 8;
  if (seen.size() < kMost)
    seen.push_back(legible(name));
  else if (seen.size() == kMost)
    seen.emplace_back("more");
}

void Draft::finish(const FileNames& exercise_files) {
  const auto not_graded = [&](const std::string& why) {
    notices.push_back(origin + ": was not graded: " + why);
  };
  for (const auto& [file, choice] : found) near.erase(file);
  if (!refused() && found.empty() && !shut.empty()) {
    refuse(Unreadable(shut.front()));
  } else if (!refused() && found.empty()) {
    std::string like;
    for (const auto& [file, name] : near) like += name + " looks like " + file + ". ";
    const std::string holds = joined(seen);
    refuse(Refused("None of the exercise files is in it (" +
                   joined({exercise_files.begin(), exercise_files.end()}) + "). " +
                   (holds.empty() ? "" : "It holds " + holds + ". ") + like +
                   "Check their names, and pack them again."));
    not_graded("no exercise file is in it" + (holds.empty() ? "" : "; it holds " + holds));
    return;
  }
  if (refused()) {
    if (notices.empty()) not_graded(submission.problem);
    return;
  }
  for (const auto& [file, name] : near)
    submission.files[file].problem = file + " is missing, and " + name + " looks like it. Give it the name " +
                                     file + ", and hand in again.";
  for (const auto& [file, choice] : found) {
    SourceFile& source = submission.files.at(file);
    if (!choice.rival.empty())
      source = {"", "There is more than one " + file + ": " + choice.taken.shown + " and " + choice.rival +
                        ". No rule says which of them counts, so none was graded. Hand in only the one that "
                        "counts."};
    const auto passed = passed_over.find(file);
    if (!source.problem.empty() || (passed == passed_over.end() && !choice.taken.renamed)) continue;
    source.choice = choice.taken.shown + " was taken for " + file;
    if (passed != passed_over.end())
      source.choice +=
          ", and not " + passed->second.first +
          (passed->second.count > 1 ? " and " + std::to_string(passed->second.count - 1) + " more" : "");
    remarks.push_back(origin + ": " + source.choice);
    source.choice += ".";
  }
  for (const auto& [file, source] : submission.files)
    if (!source.problem.empty()) not_graded(source.problem);
  for (const std::string& why : shut) notices.push_back(origin + ": " + why);
}

std::string problem_of(const Entry& entry, const std::string& shown) {
  using enum Entry::Kind;
  const std::string is = entry.kind == symbolic_link ? " is a symbolic link"
                         : entry.kind == hard_link   ? " is a link to another file"
                         : entry.kind != file        ? " is not a file"
                                                     : "";
  if (!is.empty()) return shown + is + ". Hand in the file itself.";
  if (!entry.leads_outside) return "";
  return shown +
         " leads out of the archive. Pack it again without \"..\" and without a path that begins at a root.";
}

void resolve_clashes(std::vector<Draft>& drafts, std::vector<std::string>& notices) {
  std::stable_sort(drafts.begin(), drafts.end(), comes_before);
  std::set<std::string> taken;
  std::vector<Draft> kept;
  for (Draft& draft : drafts) {
    if (!kept.empty() && kept.back().path == draft.path &&
        kept.back().submission.name == draft.submission.name) {
      notices.push_back(draft.origin + ": was given twice; it is graded once");
      continue;
    }
    taken.insert(draft.submission.name);
    kept.push_back(std::move(draft));
  }
  drafts = std::move(kept);

  for (std::size_t begin = 0, end = 0; begin < drafts.size(); begin = end) {
    const std::string name = drafts[begin].submission.name;
    while (end < drafts.size() && drafts[end].submission.name == name) ++end;
    if (end - begin == 1) continue;
    // A person chooses the names of arguments, and students the names in them: an argument keeps its name
    // even if a class holds the same one.
    const auto is_hand_in = [](const Draft& draft) { return !is_of_a_class(draft.submission.origin); };
    const auto first = drafts.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = drafts.begin() + static_cast<std::ptrdiff_t>(end);
    const bool one_stands = std::count_if(first, last, is_hand_in) == 1;
    if (one_stands) std::iter_swap(first, std::find_if(first, last, is_hand_in));
    const auto whose = [](const Draft& draft) {
      return draft.submission.owner.name + "\n" + draft.submission.owner.id;
    };
    for (std::size_t i = one_stands ? begin + 1 : begin; i < end; ++i) {
      const bool alone = std::count_if(first, last, [&](const Draft& other) {
                           return whose(other) == whose(drafts[i]);
                         }) == 1;
      std::string own = name_among_equals(name, alone ? whose(drafts[i]) : drafts[i].path);
      while (!taken.insert(own).second) own += 'x';
      drafts[i].submission.name = own;
      if (alone) continue;  // "x 1" and "x_1" are two people
      mark(drafts[i], name, drafts[i == begin ? begin + 1 : begin]);
    }
  }
  std::sort(drafts.begin(), drafts.end(), comes_before);
}

}  // namespace grader::intake
