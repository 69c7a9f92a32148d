// STAFF ONLY. results.json for the student, in Gradescope's schema (gradescope/autograder_samples,
// docs/specs.md, "Output format"). A test is a category, numbered "S1.3"; an exercise without categories (it
// is missing, it does not compile) is one test, "S1". It contains nothing of the staff's. All tests are
// visible: a hidden one would hide the student's total. It is ASCII, and has a bound: where pictures would
// break it, they are left out, and a long text is cut.
#pragma once

#include <cstddef>
#include <string>

#include "grader/result/result.h"

namespace grader::inline report {

struct ResultsOptions {
  bool pictures = false;     // inside, small; the texts say all without them
  bool leaderboard = false;  // with the points
  // It is of the public checks, which hide nothing: students see all that it says.
  bool public_checks = false;
  // As the platform says it; "": not known.
  std::string student = "", handed_in = "";
};

// The platform states no bound; PrairieLearn's is this one.
inline constexpr std::size_t kMostResultsBytes = 1'000'000;

std::string student_json(const SubmissionResult& result, const ResultsOptions& options = {});

}  // namespace grader::report
