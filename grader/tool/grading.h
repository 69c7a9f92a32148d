// STAFF ONLY. One submission from its files to its result: compile and link each exercise's file in cages,
// run its hidden suite against it, and say what became of it; then run them all together, which gives no points.
// Needs no lock: submissions are graded side by side.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "grader/compile/compiler.h"
#include "grader/compile/kit.h"
#include "grader/course/course.h"
#include "grader/intake/submission.h"
#include "grader/report/result.h"
#include "grader/tool/suite_run.h"

namespace grader {

struct GradingSettings {
  Course course;
  std::optional<std::string> exercise;  // grade this one alone
  std::filesystem::path kit, suite, scenes, cache;
  std::string secret;
  bool isolated = true;
  bool images = true;  // draw whole runs
  bool study = false;  // error against time, beside the reference: shown, and not scored
};

// What an exercise cost; the only part of a result that differs from run to run.
struct ExerciseTiming {
  double compile_seconds = 0;  // by the wall clock, linking included; 0 if it came from the cache
  double suite_seconds = 0;    // by the wall clock
  double worker_cpu_seconds = 0;
  int worker_starts = 0;
  double run_cpu_seconds = 0;      // of the worker that plays the whole run
  double picture_cpu_seconds = 0;  // to draw and compare its pictures
};

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

  // The reference in an identical worker.
  const std::map<std::string, ExerciseTiming>& reference_timing() const { return reference_; }

  const std::vector<std::string>& problems() const { return problems_; }  // ours, a line each

  // The reference beside itself: what is not 1 in its ratios is noise. Nothing without studies.
  const std::optional<SubmissionStudy>& reference_study() const { return reference_study_; }

 private:
  void grade_exercise(const Exercise& exercise, const Submission& submission,
                      const std::filesystem::path& job, ExerciseResult& result, ExerciseTiming& timing) const;
  void run_cases(const Exercise& exercise, const std::string& student, const std::filesystem::path& object,
                 const std::filesystem::path& job, ExerciseResult& result, ExerciseTiming& timing) const;
  SuiteJob end_to_end_job(const std::filesystem::path& job, const SubmissionResult& result) const;
  void run_end_to_end(const std::filesystem::path& job, Graded& graded) const;
  SubmissionStudy study(SuiteJob runs, ExerciseTiming& timing) const;
  std::optional<SuiteJob::WholeRun> whole_run(const std::string& exercise) const;
  SuiteJob suite_job(const std::string& exercise, const std::filesystem::path& job) const;
  SuiteResult timed(const SuiteJob& job, ExerciseTiming& timing) const;
  void measure_reference();
  bool selected(const Exercise& exercise) const;

  GradingSettings settings_;
  StagedKit kit_;
  Compiler compiler_;
  std::string base_fingerprint_;
  std::optional<std::filesystem::path> pictures_;  // where the reference's are kept, if any are drawn
  std::map<std::string, ExerciseTiming> reference_;
  std::optional<SubmissionStudy> reference_study_;
  std::vector<std::string> problems_;
};

// An exercise's status from those of its cases.
Status overall_status(const std::vector<CaseResult>& cases);

}  // namespace grader
