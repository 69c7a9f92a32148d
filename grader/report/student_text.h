// STAFF ONLY. A student's report as plain text: it has only what its author may see.
#pragma once

#include <string>

#include "grader/result/result.h"

namespace grader::inline report {

std::string student_text(const SubmissionResult& result);

// Joins its first lines: the points in all and of each exercise.
std::string first_lines(const SubmissionResult& result);

}  // namespace grader::report
