// STAFF ONLY. One submission from its files to its result: compile and link each exercise's file in cages,
// run its hidden suite against it, and say what became of it; then run them all together, which gives no points.
// Needs no lock: submissions are graded side by side.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/compile/kit.h"
#include "grader/course/course.h"
#include "grader/intake/submission.h"
#include "grader/report/result.h"
#include "grader/tool/reference_grading.h"
#include "grader/tool/suite_jobs.h"

namespace grader {

struct Graded {
  SubmissionResult result;
  std::map<std::string, ExerciseTiming> timing;  // by exercise, and of "runs" and "study"
  std::optional<SubmissionStudy> study;
  std::vector<std::string> problems;  // ours: what kept us from grading, a line each
};

class Grading {
 public:
  // Throws BadInput if this machine can't isolate student code and `isolated` asks for it, if it can't draw and
  // `images` asks for that, or if the reference does not get full points.
  explicit Grading(GradingSettings settings);

  // What goes wrong on our side is said in the result, which then has no fingerprint.
  Graded grade(const Submission& submission) const;

  // Of the submission's bytes, and of all else that its result depends on.
  std::string fingerprint(const Submission& submission) const;

  const Course& course() const { return settings_.course; }

  const ReferenceGraded& reference() const { return reference_; }  // in an identical worker

 private:
  void run_end_to_end(const std::filesystem::path& job, Graded& graded) const;

  GradingSettings settings_;
  StagedKit kit_;
  Compiler compiler_;
  SuiteJobs jobs_;
  std::string base_fingerprint_;
  ReferenceGraded reference_;
};

}  // namespace grader
