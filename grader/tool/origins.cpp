// STAFF ONLY. Compares origins of rows.
#include "grader/tool/origins.h"

#include <algorithm>
#include <map>
#include <set>

#include "grader/course/input.h"
#include "grader/intake/names.h"
#include "grader/intake/origin.h"
#include "grader/record/record.h"

namespace grader {
namespace {

using Names = std::set<std::string>;

// Rows without an origin are of names that clashed: they protect nothing.
std::map<std::string, Names> names_by_origin(const std::map<std::string, std::string>& rows) {
  std::map<std::string, Names> names;
  for (const auto& [name, origin] : rows)
    if (!origin.empty()) names[origin].insert(name);
  return names;
}

// The origin in the folder that a class with `names` is a later download of; its own if there is none.
std::string earlier_download(const std::string& origin, const Names& names,
                             const std::map<std::string, Names>& there) {
  if (!is_of_a_class(origin) || there.contains(origin)) return origin;
  const std::string* best = &origin;
  std::size_t most = 1;  // one name alone says too little
  for (const auto& [other, others] : there) {
    const bool same_kind = kind_of_origin(other) == kind_of_origin(origin);
    if (!same_kind || others.size() <= most || !std::ranges::includes(names, others)) continue;
    best = &other;
    most = others.size();
  }
  return *best;
}

}  // namespace

std::vector<std::string> settle_origins(const std::filesystem::path& folder,
                                        std::vector<Submission>& submissions,
                                        const std::optional<std::string>& only, bool replace,
                                        const std::string& hand_in) {
  std::map<std::string, std::string> rows, mine, settled;
  if (Record::is_in(folder)) rows = Record(folder, hand_in).origins();
  for (const Submission& submission : submissions) mine[submission.name] = submission.origin;
  const std::map<std::string, Names> there = names_by_origin(rows);
  for (const auto& [origin, names] : names_by_origin(mine))
    settled[origin] = earlier_download(origin, names, there);

  std::vector<std::string> replaced, names;
  for (Submission& submission : submissions) {
    if (!submission.origin.empty()) submission.origin = settled.at(submission.origin);
    const auto row = rows.find(submission.name);
    if (row == rows.end() || row->second.empty() || row->second == submission.origin) continue;
    if (only && *only != submission.name) continue;
    replaced.push_back(submission.name + " is there of the " + row->second + ", and here of the " +
                       submission.origin);
    names.push_back(submission.name);
  }
  if (replaced.empty() || replace) return replaced;
  throw BadInput(printable(folder.string(), 4096) + ": the rows of " + some_of(names) +
                 " are of another origin, so nothing was graded: " + replaced.front() +
                 "; leave them out, or say --replace to replace these rows");
}

}  // namespace grader
