// STAFF ONLY. Results as JSON: results.json for the student in Gradescope's schema, and the whole result for
// staff, which --resume reads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grader/result/result.h"

namespace grader {

// Gradescope's schema (gradescope-autograders.readthedocs.io, "Output format"). A test is a category,
// numbered "S1.3"; an exercise without categories (it is missing, it does not compile) is one test, "S1".
// It contains nothing of the staff's.
std::string student_json(const SubmissionResult& result);

// Everything except the pictures; it names their files.
std::string staff_json(const SubmissionResult& result);
// Reads the pictures from this folder. Nothing if the text is incomplete, or if a picture is missing or
// damaged.
std::optional<SubmissionResult> result_from_staff_json(const std::string& text,
                                                       const std::filesystem::path& pictures);

}  // namespace grader
