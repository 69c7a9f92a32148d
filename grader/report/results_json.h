// STAFF ONLY. Results as JSON: results.json for the student in Gradescope's schema, and a whole copy for
// staff, from which grading goes on where it stopped.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grader/report/result.h"

namespace grader {

// Gradescope's schema (gradescope-autograders.readthedocs.io, "Output format"). A test is a category,
// numbered "S1.3"; an exercise without categories (it is missing, it does not compile) is one test, "S1".
// Nothing of the staff's is in it.
std::string student_json(const SubmissionResult& result);

// All but the pictures, whose files it names.
std::string staff_json(const SubmissionResult& result);
// With the pictures from this folder. Nothing if the text is not whole, or one of them is missing or damaged.
std::optional<SubmissionResult> result_from_staff_json(const std::string& text,
                                                       const std::filesystem::path& pictures);

}  // namespace grader
