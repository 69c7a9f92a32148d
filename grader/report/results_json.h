// STAFF ONLY. results.json for the student, in Gradescope's schema.
#pragma once

#include <string>

#include "grader/result/result.h"

namespace grader {

// Gradescope's schema (gradescope-autograders.readthedocs.io, "Output format"). A test is a category,
// numbered "S1.3"; an exercise without categories (it is missing, it does not compile) is one test, "S1".
// It contains nothing of the staff's.
std::string student_json(const SubmissionResult& result);

}  // namespace grader
