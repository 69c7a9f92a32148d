// STAFF ONLY. Finds the people of each hand-in before it is graded, and its place in the record: groups get
// their members from the roster, and hand-ins the names that they had in the record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/record/record.h"
#include "grader/roster/roster.h"

namespace grader::inline class_folder {

// See grader/roster/groups.h; remarks say what was found, and a person must look at notices.
void give_members(Intake& intake, const Roster& roster);

// Gives submissions the names that they have in the record (grader/record/same_people.h), and sorts by them;
// `listed` gets them, too. In blind grading names are codes already. Returns a line each for staff. `only`, a
// name of one of them, becomes the record's.
std::vector<std::string> keep_rows(std::vector<Submission>& submissions, std::vector<Accounted>& listed,
                                   Record& record, std::optional<std::string>& only);

}  // namespace grader::class_folder
