// STAFF ONLY. A submission while it is read.
#include "grader/intake/draft.h"

#include <numeric>
#include <utility>

#include "grader/text/letters.h"

namespace grader {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return std::accumulate(
      words.begin(), words.end(), std::string(),
      [](const std::string& text, const auto& word) { return text + (text.empty() ? "" : ", ") + word; });
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
  const auto [at, is_first] = found.try_emplace(exercise_file, where);
  Found& first = at->second;
  SourceFile& taken = submission.files[exercise_file];
  if (is_first || (first.renamed && !where.renamed)) {
    if (!is_first)
      remarks.push_back(origin + ": " + first.shown + " was not taken, since " + where.shown + " is there");
    first = where;
    taken = std::move(file);
  } else if (!first.renamed && where.renamed) {
    remarks.push_back(origin + ": " + where.shown + " was not taken, since " + first.shown + " is there");
  } else if (taken.text != file.text || !taken.problem.empty() || !file.problem.empty()) {
    taken = {"", "There is more than one " + exercise_file + ": " + first.shown + " and " + where.shown +
                     ". Hand in only the one that counts."};
  }
}

void Draft::see(std::string_view name) {
  constexpr std::size_t kMost = 8;
  if (seen.size() < kMost)
    seen.push_back(legible(name));
  else if (seen.size() == kMost)
    seen.emplace_back("more");
}

void Draft::finish(const FileNames& exercise_files) {
  if (refused()) return;
  for (const auto& [file, where] : found) {
    if (where.renamed && submission.files.at(file).problem.empty())
      remarks.push_back(origin + ": " + where.shown + " was taken for " + file);
    near.erase(file);
  }
  std::string like;
  for (const auto& [file, name] : near) like += name + " looks like " + file + ". ";
  if (found.empty()) {
    std::string wanted;
    for (const std::string& file : exercise_files) wanted += (wanted.empty() ? "" : ", ") + file;
    const std::string holds = joined(seen);
    if (!shut.empty())
      refuse(Unreadable(shut.front()));
    else
      refuse(Refused("None of the exercise files is in it (" + wanted + "). " +
                     (holds.empty() ? "" : "It holds " + holds + ". ") + like +
                     "Check their names, and pack them again."));
    if (shut.empty())
      remarks.push_back(origin + ": no exercise file is in it" +
                        (holds.empty() ? "" : "; it holds " + holds));
    return;
  }
  for (const auto& [file, name] : near) {
    submission.files[file] = {"", file + " is missing, and " + name + " looks like it. Give it the name " +
                                      file + ", and hand in again."};
    remarks.push_back(origin + ": " + file + " is missing, and " + name + " looks like it");
  }
  for (const std::string& why : shut) notices.push_back(origin + ": " + why);
}

std::string problem_of(const Entry& entry, const std::string& shown) {
  switch (entry.kind) {
    case Entry::Kind::symbolic_link:
      return shown + " is a symbolic link. Hand in the file itself.";
    case Entry::Kind::hard_link:
      return shown + " is a link to another file. Hand in the file itself.";
    case Entry::Kind::special:
    case Entry::Kind::folder:
      return shown + " is not a file. Hand in the file itself.";
    case Entry::Kind::file:
      break;
  }
  if (!entry.leads_outside) return "";
  return shown +
         " leads out of the archive. Pack it again without \"..\" and without a path that begins at a root.";
}

}  // namespace grader
