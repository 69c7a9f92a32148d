// STAFF ONLY. The public checks of a hand-in, as a platform shows them before the deadline: each file is
// compiled as in grading, with the same messages, and its checks run in a sandbox with the student's own
// prerequisites, as at home. They give no points. It has no secret and no reference; the student's process
// itself reports which check passed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/grading/grading.h"
#include "grader/intake/submission.h"

namespace grader::inline tool {

class PublicChecks {
 public:
  // `programs` has a program for each exercise, which looks for objects in /objects; `golden` is their data,
  // which they find in `golden_inside`. Keeps references.
  PublicChecks(const Compiler& compiler, const std::filesystem::path& programs,
               const std::filesystem::path& golden, std::filesystem::path golden_inside, Isolation isolation);

  SubmissionResult check(const Course& course, const Submission& submission,
                         const Grading::AfterEach& after_each) const;

 private:
  struct Ran {
    bool well = false;
    std::string output;
  };
  ExerciseResult check_exercise(const Exercise& exercise, const Submission& submission,
                                const std::filesystem::path& job) const;
  Ran run(const Exercise& exercise, const std::filesystem::path& job) const;

  const Compiler& compiler_;
  const StagedKit& kit_;
  std::filesystem::path staged_, golden_inside_;
  Isolation isolation_;
};

// Returns the checks of a program's output, each a category without points; and one about its end if no check
// reports it.
std::vector<CaseResult> checks_in(const std::string& output, bool ended_well);

}  // namespace grader::tool
