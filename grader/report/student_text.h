// STAFF ONLY. A student's report as plain text: what its author sees, and nothing else.
#pragma once

#include <string>

#include "grader/result/result.h"

namespace grader::inline report {

std::string student_text(const SubmissionResult& result);

// Its first lines as one: the points in all and of each exercise.
std::string first_lines(const SubmissionResult& result);

}  // namespace grader::report
