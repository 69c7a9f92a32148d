// STAFF ONLY. Grades one submission, from its files to its result: compiles and links each exercise's file in
// sandboxes and runs its hidden suite; then studies all files together, if this is requested. It needs no
// lock: submissions are graded in parallel.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/compile/toolchain.h"
#include "grader/course/course.h"
#include "grader/grading/made_by.h"
#include "grader/grading/suite_jobs.h"
#include "grader/intake/submission.h"
#include "grader/result/result.h"

namespace grader::inline grading {

struct Graded {
  SubmissionResult result;
  TimingByExercise timing;  // by exercise, and for kStudy
  std::optional<SubmissionStudy> study;
  std::vector<std::string> problems;  // on our side: what prevented grading, a line each
  std::filesystem::path job = {};     // holds its objects if a part has ended by wall time
};

// Hashes the files that were handed in, and their problems.
std::string hash_of_files(const Submission& submission);

class Grading {
 public:
  // Throws BadInput if `images` is set and this machine can't draw, or if the reference gets less than full
  // points. With `reference`, its time on another machine, this one does not grade it.
  explicit Grading(GradingSettings settings, std::optional<TimingByExercise> reference = {});

  // Errors on our side are in the result, which then has no fingerprint. `after_each` sees the result so far
  // after each exercise.
  using AfterEach = std::function<void(const SubmissionResult&)>;
  Graded grade(const Submission& submission, const AfterEach& after_each = {}) const;

  // Grades the parts again that ended by wall time, and keeps the rest. The machine should have nothing else
  // to do.
  void grade_again(const Submission& submission, Graded& graded) const;

  // Hashes the submission's bytes, and everything else that its result depends on.
  std::string fingerprint(const Submission& submission) const;

  const Course& course() const { return settings_.course; }
  bool studies() const { return settings_.study && !settings_.exercise; }
  Isolation isolation() const { return settings_.isolation; }
  const MadeBy& made_by() const { return made_by_; }

  const TimingByExercise& reference() const { return reference_; }  // ran in an identical worker

 private:
  void grade_one(const Submission& submission, const Exercise& exercise, double& compiler_seconds,
                 ExerciseResult& result, Graded& graded) const;
  void finish(Graded& graded) const;

  GradingSettings settings_;
  MadeBy made_by_;
  StagedKit kit_;
  Compiler compiler_;
  SuiteJobs jobs_;
  std::string base_fingerprint_;
  TimingByExercise reference_;
};

}  // namespace grader::grading
