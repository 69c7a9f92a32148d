// STAFF ONLY. Blind grading: graders see codes instead of names. A code is drawn at random at first sight and
// stored, so that no name leads to it; it is the name of folders and files, too. The record maps codes to
// people, and gradebooks and feedback show names as ever.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/result/result.h"
#include "grader/roster/hidden_names.h"

namespace grader::inline class_folder {

// Lists the owners of the submissions, for the record.
std::vector<HandIn> hand_ins_of(const std::vector<Submission>& submissions);

// Names submissions by their codes, `known` or new ones, and sorts them by these. The names from intake are
// `known_as` then.
void give_codes(std::vector<Submission>& submissions, const std::map<std::string, std::string>& known);

void hide(const HiddenNames& names, Intake& intake);  // changes all lines
void hide(const HiddenNames& names, std::vector<Accounted>& listed);
// Hides names in all texts from the hand-in, and in its path.
void hide(const HiddenNames& names, SubmissionResult& result);

// Returns a line for each hand-in, without its owner.
std::vector<ClassLine> blind(const std::vector<ClassLine>& lines);

}  // namespace grader::class_folder
