// STAFF ONLY. Finds submissions' people, origins and names in the record, and hides names in blind grading.
#include "grader/class_folder/plan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "grader/class_folder/blind.h"
#include "grader/course/input.h"
#include "grader/roster/groups.h"

namespace grader::inline class_folder {
namespace {

std::string names_of(const std::vector<Submission>& submissions) {
  constexpr std::size_t kMost = 20;
  std::string names;
  for (std::size_t i = 0; i < submissions.size() && i < kMost; ++i)
    names += (i > 0 ? ", " : "") + submissions[i].name;
  return names + (submissions.size() > kMost ? " and more" : "");
}

}  // namespace

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

void give_members(Intake& intake, const Roster& roster) {
  std::vector<HandIn> hand_ins = hand_ins_of(intake.submissions);
  Membership found = find_members(hand_ins, roster);
  std::ranges::move(found.said, std::back_inserter(intake.remarks));
  std::ranges::move(found.doubts, std::back_inserter(intake.notices));
  for (std::size_t i = 0; i < hand_ins.size(); ++i)
    if (!hand_ins[i].owner.members.empty()) intake.submissions[i].owner = std::move(hand_ins[i].owner);
}

Plan plan_of(Intake intake, Record& record, const std::optional<Roster>& known,
             const BatchSettings& settings) {
  const bool blind = settings.blind || record.is_blind();
  std::optional<std::string> only = settings.only;
  if (blind) give_codes(intake.submissions, record.codes());
  std::vector<Accounted> listed = grader::listed(intake);
  std::ranges::move(keep_rows(intake.submissions, listed, record, only), std::back_inserter(intake.remarks));
  if (only && std::ranges::count(intake.submissions, *only, &Submission::name) == 0)
    throw BadInput("--only " + *only + ": no submission has that name; there are " +
                   names_of(intake.submissions));
  if (blind) {
    const std::vector<HandIn> hand_ins = hand_ins_of(intake.submissions);
    const HiddenNames names(hand_ins, known ? std::optional(class_list(*known, hand_ins)) : std::nullopt);
    hide(names, intake);
    hide(names, listed);
  }
  Settled settled = settle_origins(settings.out, intake.submissions, only, settings.word, settings.hand_in);
  std::ranges::move(settled.missing, std::back_inserter(intake.notices));
  return {.submissions = std::move(intake.submissions),
          .only = std::move(only),
          .blind = blind,
          .listed = std::move(listed),
          .replaced = std::move(settled.replaced),
          .taken_for = std::move(intake.taken_for),
          .notices = std::move(intake.notices),
          .remarks = std::move(intake.remarks)};
}

}  // namespace grader::class_folder
