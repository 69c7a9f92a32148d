// STAFF ONLY. Takes the exercise files out of containers.
#include "grader/intake/hand_in_reader.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"
#include "grader/intake/names/same_name.h"
#include "grader/text/encoding.h"
#include "grader/text/letters.h"
#include "hair/io/plot/readable.h"

namespace grader::inline intake {
namespace {

constexpr std::size_t kDeepestNesting = 3;  // class.zip, Alice_1.zip in it, handin.tar.gz in that
constexpr std::size_t kMostArchives = 20;
const std::string kAboutFile = "about.txt";
constexpr std::size_t kMostAboutBytes = std::size_t{16} << 10;

}  // namespace

Share whole_share(Draft& draft, const std::vector<Entry>& list) {
  Share all{.draft = &draft, .entries = {}};
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!is_ignored(list[i].path)) all.entries.push_back(i);
  return all;
}

HandInReader::Plan HandInReader::plan_share(const std::vector<Entry>& list, const Share& share,
                                            const std::string& prefix, std::size_t depth) {
  Draft& draft = *share.draft;
  draft.budget.charge_entries(share.entries.size());
  Plan plan;
  std::vector<std::size_t> archives;
  std::map<std::string, std::vector<Candidate>> candidates;  // by exercise file
  for (const std::size_t i : share.entries) {
    const Entry& entry = list[i];
    const std::string shown = legible(prefix + entry.shown);
    if (entry.closed) throw Unreadable("The folder " + shown + " can't be read.");
    if (entry.kind == Entry::Kind::folder || entry.replaced) continue;
    const std::string_view name = name_of(entry);
    if (const auto about = exercise_file(name, {kAboutFile});
        about && about->degree != Likeness::Degree::like && !entry.encrypted &&
        problem_of(entry, shown).empty()) {
      draft.budget.charge_bytes(std::min<std::uintmax_t>(entry.bytes, kMostAboutBytes));
      draft.see(name);
      plan[i] = {&draft, kAboutFile, {shown}};
      continue;
    }
    const auto likeness = exercise_file(name, files_);
    if (!likeness || likeness->degree == Likeness::Degree::like) {
      if (has_archive_ending(name)) archives.push_back(i);
      draft.see(name);
      if (likeness) draft.near.try_emplace(likeness->file, legible(name));
      continue;
    }
    candidates[likeness->file].push_back(
        {i, entry.path, likeness->degree == Likeness::Degree::renamed, likeness->number});
  }
  for (auto& [file, all] : candidates) plan_files(list, draft, file, all, prefix, plan);
  if (share.is_document) {
    throw Unreadable(legible(name_of(list[share.entries.front()])) +
                     " is no archive. Hand in a .zip or .tar.gz archive with the exercise files.");
  }
  if (share.is_attached || candidates.empty()) {
    plan_archives(list, share, archives, prefix, depth, plan);
    return plan;
  }
  std::string shut;
  std::size_t count = 0;
  for (const std::size_t i : archives) {
    if (lies_in_a_build(list[i].path)) continue;
    if (count++ == 0) shut = legible(prefix + list[i].shown);
  }
  if (count > 0)
    draft.notices.push_back(draft.origin + ": " + shut +
                            " was not opened, since there are exercise files beside it" +
                            (count > 1 ? ", and " + std::to_string(count - 1) + " more" : ""));
  return plan;
}

void HandInReader::plan_files(const std::vector<Entry>& list, Draft& draft, const std::string& file,
                              std::vector<Candidate>& candidates, const std::string& prefix, Plan& plan) {
  const std::size_t best = put_best_first(candidates);
  if (best < candidates.size())
    draft.pass_over(file, legible(prefix + list[candidates[best].entry].shown), candidates.size() - best);
  candidates.resize(best);
  for (const Candidate& one : candidates) {
    const Entry& entry = list[one.entry];
    const Found where{legible(prefix + entry.shown), is_set_aside(prefix + entry.path), one.renamed};
    if (entry.encrypted) throw Unreadable(where.shown + " is encrypted. Pack it again without a password.");
    if (std::string problem = problem_of(entry, where.shown); !problem.empty()) {
      draft.offer(file, where, {"", std::move(problem)});
      continue;
    }
    draft.budget.charge_bytes(std::min<std::uintmax_t>(entry.bytes, limits_.file_bytes));
    plan[one.entry] = {&draft, file, where};
  }
}

void HandInReader::plan_archives(const std::vector<Entry>& list, const Share& share,
                                 const std::vector<std::size_t>& archives, const std::string& prefix,
                                 std::size_t depth, Plan& plan) {
  Draft& draft = *share.draft;
  for (const std::size_t i : archives) {
    const Entry& entry = list[i];
    const std::string shown = legible(prefix + entry.shown);
    if (depth == kDeepestNesting) {
      draft.notices.push_back(draft.origin + ": " + shown + " was not opened: it is an archive in " +
                              std::to_string(depth) + " others");
      continue;
    }
    if (entry.encrypted) throw Unreadable(shown + " is encrypted. Pack it again without a password.");
    if (const std::string problem = problem_of(entry, shown); !problem.empty()) throw Refused(problem);
    draft.budget.charge_bytes(entry.bytes);
    // A submission's own archive is named without the class around it.
    plan[i] = {&draft, "", {share.is_archive ? legible(name_of(entry)) : shown}};
  }
}

// about.txt changes no points, so an unreadable one is only a remark.
void HandInReader::take_about(Draft& draft, const std::string& shown, const Container::Read& read) {
  try {
    std::string text = decoded(read(kMostAboutBytes), shown).text;
    std::erase(text, '\r');
    text = hair::readable(text);
    if (draft.submission.about.empty())
      draft.submission.about = text;
    else if (draft.submission.about != text)
      draft.remarks.push_back(draft.origin + ": " + shown + " was not read, since there is another one");
  } catch (const std::runtime_error& why) {  // Refused, or BadInput for its encoding
    draft.remarks.push_back(draft.origin + ": " + shown + " was not read: " + why.what());
  }
}

void HandInReader::take_archive(Draft& draft, std::string bytes, const std::string& shown,
                                std::size_t depth) {
  if (++draft.archives > kMostArchives) {
    throw Refused("More than " + std::to_string(kMostArchives) + " archives were handed in. Hand in one.");
  }
  const std::unique_ptr<Container> archive =
      open_archive_(std::move(bytes), shown, draft.budget.for_archive());
  std::vector<Entry> list = archive->list();
  for (std::string& line : settle_names(list, draft.origin)) draft.remarks.push_back(std::move(line));
  take(*archive, list, {whole_share(draft, list)}, shown + "/", depth);
}

void HandInReader::take(Container& container, const std::vector<Entry>& list,
                        const std::vector<Share>& shares, const std::string& prefix, std::size_t depth) {
  Plan plan;
  for (const Share& share : shares) {
    try {
      plan.merge(plan_share(list, share, prefix, depth));
    } catch (const Refused& why) {
      share.draft->refuse(why);
    }
  }
  std::vector<std::size_t> indices;
  for (const auto& [index, wanted] : plan) indices.push_back(index);
  container.visit(indices, [&](std::size_t index, const Container::Read& read) {
    const Wanted& wanted = plan.at(index);
    Draft& draft = *wanted.draft;
    if (draft.refused()) return;
    if (wanted.file == kAboutFile) {
      take_about(draft, wanted.where.shown, read);
      return;
    }
    if (!wanted.file.empty()) {
      SourceFile file;
      try {
        file.text = read(limits_.file_bytes);
      } catch (const Refused& why) {
        file.problem = why.what();
      }
      draft.offer(wanted.file, wanted.where, std::move(file));
      return;
    }
    try {
      take_archive(draft, read(limits_.unpacked_bytes), wanted.where.shown, depth + 1);
    } catch (const Unreadable& why) {
      draft.shut.emplace_back(why.what());  // other archives in it may be readable
      if (!why.failure().empty()) draft.remarks.push_back(draft.origin + ": " + why.failure());
    } catch (const Refused& why) {
      draft.refuse(why);
    }
  });
}

}  // namespace grader::intake
