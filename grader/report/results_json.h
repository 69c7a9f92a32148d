// STAFF ONLY. results.json for the student, in Gradescope's schema (gradescope/autograder_samples,
// docs/specs.md, "Output format"). A test is a category, numbered "S1.3"; an exercise that passes whole, is
// excused or has no categories (it is missing, it does not compile) is one test, "S1". It contains no staff's
// text. All tests are visible: a hidden one would hide the student's total. It is ASCII, and has a bound:
// pictures that would break it are left out, and a long text is cut.
#pragma once

#include <cstddef>
#include <string>

#include "grader/result/result.h"

namespace grader::inline report {

struct ResultsOptions {
  bool pictures = false;  // inside, small; the texts are complete without them
  // Marks results of the public checks, which hide nothing: students see the whole output.
  bool public_checks = false;
  // These come from the platform; "": unknown.
  std::string student = "", handed_in = "";
};

// The platform states no bound; PrairieLearn's is this one.
inline constexpr std::size_t kMostResultsBytes = 1'000'000;

std::string student_json(const SubmissionResult& result, const ResultsOptions& options = {});

// Returns the same of one exercise in PrairieLearn's schema (docs/externalGrading.md, "Grading results"). An
// exercise without categories (it is missing, it does not compile) is not gradable, nor is a result without
// the exercise, which is our fault: neither costs an attempt.
std::string prairielearn_json(const SubmissionResult& result, const std::string& exercise,
                              bool pictures = true);

}  // namespace grader::report
