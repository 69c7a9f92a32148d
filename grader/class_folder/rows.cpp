// STAFF ONLY. Finds members of groups, and earlier submissions.
#include "grader/class_folder/rows.h"

#include <algorithm>
#include <map>

#include "grader/class_folder/blind.h"
#include "grader/roster/groups.h"

namespace grader::inline class_folder {

void give_members(Intake& intake, const Roster& roster) {
  std::vector<HandIn> hand_ins = hand_ins_of(intake.submissions);
  Membership found = find_members(hand_ins, roster);
  std::ranges::move(found.said, std::back_inserter(intake.remarks));
  std::ranges::move(found.doubts, std::back_inserter(intake.notices));
  for (std::size_t i = 0; i < hand_ins.size(); ++i)
    if (!hand_ins[i].owner.members.empty()) intake.submissions[i].owner = std::move(hand_ins[i].owner);
}

std::vector<std::string> keep_rows(std::vector<Submission>& submissions, std::vector<Accounted>& listed,
                                   Record& record, std::optional<std::string>& only) {
  std::vector<std::string> said;
  std::map<std::string, std::string> rows;
  const std::vector<RowName> names = record.row_names(hand_ins_of(submissions));
  for (std::size_t i = 0; i < names.size(); ++i) {
    rows[submissions[i].name] = names[i].name;
    submissions[i].name = names[i].name;
    if (!names[i].told.empty()) said.push_back(names[i].told);
  }
  if (only)
    if (const auto row = rows.find(*only); row != rows.end()) only = row->second;
  for (Accounted& file : listed)
    if (const auto row = rows.find(file.whose); row != rows.end()) file.whose = row->second;
  std::ranges::sort(submissions, {}, &Submission::name);
  return said;
}

}  // namespace grader::class_folder
