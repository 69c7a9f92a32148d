// STAFF ONLY. A student's report as plain text: it has only what its author may see.
#pragma once

#include <string>

#include "grader/result/result.h"

namespace grader::inline report {

std::string student_text(const SubmissionResult& result);

// Returns the error of the whole submission, changes of its total, and remarks of the staff: a paragraph
// each.
std::string said_of_the_whole(const SubmissionResult& result);
// Names the category or the line that it is about, "conj_grad.cpp, line 17: "; "" for the exercise.
std::string about(const Said& said, const ExerciseResult& exercise);

// Returns its feedback, and what people say about it.
std::string said_of_exercise(const ExerciseResult& exercise);

std::string joined(const std::string& first, const std::string& second);  // makes two paragraphs

// Joins its first lines: the points in all and of each exercise.
std::string first_lines(const SubmissionResult& result);

}  // namespace grader::report
