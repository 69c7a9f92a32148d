// STAFF ONLY. Whose hand-ins are, before they are graded: groups get their members from the roster, and hand-ins the rows in the record that
// they had before.
#pragma once

#include <vector>

#include "grader/intake/submission.h"
#include "grader/record/record.h"
#include "grader/roster/roster.h"

namespace grader {

// See grader/roster/groups.h; remarks say what was found.
void give_members(Intake& intake, const Roster& roster);

// Submissions are called as their rows (grader/record/same_people.h), and sorted by that; `listed` names them so, too. Names are codes
// already where grading is blind. Returns a line each for staff.
std::vector<std::string> keep_rows(std::vector<Submission>& submissions, std::vector<Accounted>& listed,
                                   Record& record);

}  // namespace grader
