// STAFF ONLY. Finds the people and the row of each hand-in before it is graded: groups get their members from
// the roster, and hand-ins the rows in the record that they had before.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/record/record.h"
#include "grader/roster/roster.h"

namespace grader::inline tool {

// See grader/roster/groups.h; remarks say what was found, and notices what a person must look at.
void give_members(Intake& intake, const Roster& roster);

// Submissions are called as their rows (grader/record/same_people.h), and sorted by that; `listed` names them
// so, too. Names are codes already where grading is blind. Returns a line each for staff. `only`, a name of
// one of them, becomes that of its row.
std::vector<std::string> keep_rows(std::vector<Submission>& submissions, std::vector<Accounted>& listed,
                                   Record& record, std::optional<std::string>& only);

}  // namespace grader::tool
