// STAFF ONLY. Blind grading: whoever looks at grades sees codes. A code is drawn at random at first sight and
// stored, so that no name leads to it; it is the name of folders and files, too. The record knows whose it
// is, and gradebooks and feedback are for people as ever.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/result/result.h"
#include "grader/roster/hidden_names.h"

namespace grader::inline tool {

// Whose the submissions are, for the record.
std::vector<HandIn> hand_ins_of(const std::vector<Submission>& submissions);

// Names submissions by their codes, `known` or new ones, and sorts them by these. The names that intake found
// are `known_as` then.
void give_codes(std::vector<Submission>& submissions, const std::map<std::string, std::string>& known);

void hide(const HiddenNames& names, Intake& intake);  // in all lines
void hide(const HiddenNames& names, std::vector<Accounted>& listed);
// In all that comes from the hand-in, and where that lay.
void hide(const HiddenNames& names, SubmissionResult& result);

// A line for each hand-in, without whose it is.
std::vector<ClassLine> blind(const std::vector<ClassLine>& lines);

}  // namespace grader::tool
