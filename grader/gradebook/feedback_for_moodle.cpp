// STAFF ONLY. Writes feedback under participants' numbers.
#include <algorithm>
#include <map>

#include "grader/course/input.h"
#include "grader/gradebook/feedback.h"
#include "grader/roster/roster.h"
#include "grader/roster/worksheet.h"
#include "grader/text/letters.h"

namespace grader::inline gradebook {
namespace {

// Returns the word in "Participant 4711", in the worksheet's language.
std::string word_of(const std::string& identifier) {
  return squeezed(identifier.substr(0, identifier.find_last_not_of("0123456789") + 1));
}

}  // namespace

Feedback feedback_for_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const ReportOf& report) {
  std::size_t identifier = column_of(worksheet, "Identifier");
  if (identifier == kNoColumn)
    if (const std::optional<Worksheet> sheet = worksheet_by_form(worksheet)) identifier = sheet->identifier;
  if (identifier == kNoColumn)
    throw BadInput(
        place_of(worksheet, worksheet.rows.front()) +
        ": no title is \"Identifier\", and the table has not the form of a worksheet, which begins with "
        "\"Participant 4711\"; download the grading worksheet of the assignment");
  const Roster roster(worksheet);
  std::map<std::size_t, std::string> words;
  for (const Csv::Row& row : worksheet.rows) words[row.line] = word_of(composed(row.at(identifier)));

  Feedback feedback;
  std::map<std::string, std::vector<const Grade*>> by_number;
  for (const Grade& grade : grades) {
    const bool members = !grade.owner.members.empty();
    for (const Owner& owner : members ? grade.owner.members : std::vector{grade.owner}) {
      const Roster::Match match = roster.find(owner, "moodle");
      std::string why_not = match.told;
      if (match.person && why_not.empty()) {
        const Person& person = roster.people()[*match.person];
        // A blind worksheet has no names, and a download of teams no participants.
        if (person.name.empty() && !owner.name.empty() && squeezed(owner.name) != words[person.line] &&
            !owner.anonymous)
          why_not = "number " + owner.id + " is a participant's in the worksheet, and " +
                    composed(owner.name) + " is a team's name or another person's";
        else
          by_number[person.id(IdKind::participant)].push_back(&grade);
      }
      if (!why_not.empty())
        feedback.said.push_back(grade.hand_in +
                                (members ? ", " + composed(owner.name.empty() ? owner.id : owner.name) : "") +
                                ": gets no feedback: " + why_not);
    }
  }
  for (const auto& [number, theirs] : by_number) {
    if (theirs.size() > 1) {
      feedback.said.push_back("participant " + number + ": gets no feedback: both " + theirs[0]->hand_in +
                              " and " + theirs[1]->hand_in + " are theirs");
      continue;
    }
    std::string who = theirs[0]->hand_in;
    std::ranges::replace(who, '_', '-');  // Moodle splits at it
    feedback.entries.push_back({.path = who + "_" + number + "_assignfeedback_file/report.html",
                                .bytes = report(theirs[0]->hand_in).page,
                                .link = ""});
  }
  feedback.said.emplace_back(
      "each gets report.html as a feedback file; Moodle takes no grades from this archive: give those by its "
      "worksheet");
  return feedback;
}

}  // namespace grader::gradebook
