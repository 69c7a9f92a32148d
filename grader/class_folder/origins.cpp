// STAFF ONLY. Compares submissions' origins and bytes with the record's.
#include "grader/class_folder/origins.h"

#include <map>
#include <set>

#include "grader/grading/grading.h"
#include "grader/intake/names/names.h"
#include "grader/intake/submission.h"
#include "grader/record/record.h"

namespace grader::inline class_folder {
namespace {

using Names = std::vector<std::string>;
using RowsByName = std::map<std::string, Record::Row>;
using People = std::map<std::string, const Submission*>;  // by their names in the record

bool is_the_same(const Submission& submission, const Record::Row& row) {
  return hash_of_files(submission) == row.files;
}

// Holds the class in the folder with this path, else the one that shares most people with this one.
struct Earlier {
  std::string origin = {};  // "": there is no class in the folder
  int shared = 0;
};
Earlier earlier_class(const std::string& origin, const People& people, const RowsByName& rows) {
  std::map<std::string, int> shared;
  for (const auto& [name, row] : rows)
    if (is_of_a_class(row.origin)) shared[row.origin] += people.contains(name) ? 1 : 0;
  if (shared.contains(origin)) return {origin, shared.at(origin)};
  Earlier most;
  for (const auto& [other, count] : shared)
    if (most.origin.empty() || count > most.shared) most = {other, count};
  return most;
}

// Equal bytes of several students, such as a stub's, prove nothing: others know them. A hand-in without files
// proves nothing either.
bool has_most_as_they_were(const People& people, const std::string& earlier, const RowsByName& rows) {
  std::map<std::string, int> with_bytes;
  for (const auto& [name, row] : rows) ++with_bytes[row.files];
  int before = 0, again = 0;
  for (const auto& [name, row] : rows) {
    if (row.origin != earlier || with_bytes.at(row.files) > 1) continue;
    const auto now = people.find(name);
    const bool same = now != people.end() && is_the_same(*now->second, row);
    if (same && now->second->files.empty()) continue;
    ++before;
    again += same ? 1 : 0;
  }
  return again > 1 && 2 * again > before;
}

// Lists the submissions that a class would change, as a part of a sentence; "": there are none.
std::string changes(const People& people, const RowsByName& rows, const std::optional<std::string>& only) {
  Names replaced, added;
  for (const auto& [name, submission] : people) {
    const auto row = rows.find(name);
    if (only && *only != name) continue;
    if (row == rows.end() && !only) added.push_back(name);
    if (row != rows.end() && !is_the_same(*submission, row->second)) replaced.push_back(name);
  }
  if (added.empty()) return replaced.empty() ? "" : "replace the rows of " + some_of(replaced);
  return (replaced.empty() ? "" : "replace the rows of " + some_of(replaced) + " and ") + "add rows of " +
         some_of(added);
}

// Returns why a class must not change submissions without the caller's word; "": it may.
std::string doubt_about(const std::string& origin, const People& people, const Earlier& earlier,
                        const RowsByName& rows, const CallersWord& word) {
  if (word.replace || word.class_over_rows) return "";
  if (!earlier.origin.empty() && earlier.shared == 0)
    return "nobody who was graded of the " + earlier.origin + " is in the " + origin +
           " (if it is the same class under other names or numbers, grade it into a new folder)";
  if (earlier.origin == origin) return "";
  if (earlier.shared > 0 && has_most_as_they_were(people, earlier.origin, rows)) return "";
  return "the " + origin +
         " may be one student's hand-in, for not even most of the hand-ins that were graded are in it "
         "unchanged";
}

}  // namespace

Settled settle_origins(const std::filesystem::path& folder, std::vector<Submission>& submissions,
                       const std::optional<std::string>& only, const CallersWord& word,
                       const std::string& hand_in) {
  const RowsByName rows = Record::is_in(folder) ? Record(folder, hand_in).rows() : RowsByName();
  if (rows.empty()) return {};
  const std::string where = printable(folder.string(), 4096);
  std::map<std::string, People> given;
  std::set<std::string> here, earlier_ones;
  for (const Submission& submission : submissions) {
    given[submission.origin][submission.name] = &submission;
    here.insert(submission.name);
  }
  std::map<std::string, std::string> settled;
  for (const auto& [origin, people] : given) {
    settled[origin] = origin;
    if (!is_of_a_class(origin)) continue;
    const Earlier earlier = earlier_class(origin, people, rows);
    const std::string doubt = doubt_about(origin, people, earlier, rows, word),
                      change = doubt.empty() ? "" : changes(people, rows, only);
    if (!change.empty())
      throw Question(where + ": " + doubt + "; nothing was graded, since it would " + change +
                         "; if it is a download of a class, say",
                     kSaysClass);
    if (earlier.shared == 0) continue;
    settled[origin] = earlier.origin;
    earlier_ones.insert(earlier.origin);
  }

  Settled lines;
  Names replaced, missing;
  for (Submission& submission : submissions) {
    submission.origin = settled.at(submission.origin);
    const auto row = rows.find(submission.name);
    // A submission without an origin had a name that clashed: it protects nothing.
    if (row == rows.end() || row->second.origin.empty() || row->second.origin == submission.origin) continue;
    if ((only && *only != submission.name) || is_the_same(submission, row->second)) continue;
    lines.replaced.push_back(submission.name + " is there of the " + row->second.origin +
                             ", and here of the " + submission.origin);
    replaced.push_back(submission.name);
  }
  if (!replaced.empty() && !word.replace)
    throw Question(where + ": the rows of " + some_of(replaced) +
                       " are of another origin, so nothing was graded: " + lines.replaced.front() +
                       "; leave them out, or, to replace these rows, say",
                   kSaysReplace);
  for (const auto& [name, row] : rows)
    if (!only && earlier_ones.contains(row.origin) && !here.contains(name)) missing.push_back(name);
  if (!missing.empty())
    lines.missing.push_back("not in this download, but in an earlier one: " + some_of(missing) +
                            "; such rows stay as they are (hairgrade forget removes who has left)");
  return lines;
}

}  // namespace grader::class_folder
