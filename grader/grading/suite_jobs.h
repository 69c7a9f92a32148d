// STAFF ONLY. The jobs for hidden suites, with their folders, seeds and limits, and the cost of running them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/toolchain.h"
#include "grader/course/course.h"
#include "grader/judge/job.h"
#include "grader/result/costs.h"
#include "grader/result/result.h"
#include "grader/result/suite_result.h"
#include "grader/sandbox/processes/processors.h"

namespace grader::inline grading {

struct GradingSettings {
  Course course;
  std::optional<std::string> exercise;  // grades only this one
  std::filesystem::path kit, suite, study_program, runners, scenes, cache;
  std::filesystem::path reference;  // holds its sources
  std::string secret;
  Isolation isolation = Isolation::namespaces;
  bool images = true;  // draws whole runs
  bool study = false;  // error against time, compared with the reference: shown, but not scored
};

// This is the study's name in the timing, next to those of the exercises.
inline constexpr const char* kStudy = "study";

// This is the file in a job's folder with its workers' output.
inline constexpr const char* kLog = "output";

class SuiteJobs {
 public:
  // Throws BadInput if `images` is set and this machine can't draw. Keeps references to its arguments.
  SuiteJobs(const GradingSettings& settings, const StagedKit& kit);

  const GradingSettings& settings() const { return settings_; }
  const StagedKit& kit() const { return kit_; }

  // Hashes everything that results depend on: kit, suite, runners, scenes, secret, renderer, course.
  std::string fingerprint() const;

  // From now on a worker's limit is a multiple of the reference's time.
  void limit_by(TimingByExercise reference) { reference_ = std::move(reference); }

  bool selected(const Exercise& exercise) const;  // true if it is graded

  // Returns the budget of an exercise or a study: its share of the course's budget, also if others are not
  // selected; and 20 times the reference's CPU time and messages, for which each field has a least limit.
  Budget allowance(const std::string& exercise) const;
  bool ended_by_the_clock(const ExerciseTiming& timing) const;

  // Returns the limit of compiler and linker for a file: its share of the course's budget; and 4.5 times the
  // time of the reference's file, or rather the mean of that and of an average file.
  double compiler_seconds(const Exercise& exercise) const;

  // Makes the job of an exercise's cases and whole run; the suite provides the object's prerequisites.
  SuiteJob cases(const Exercise& exercise, const std::string& student, const std::filesystem::path& object,
                 const std::filesystem::path& folder) const;

  // Makes a job for hairstudy with all of the reference's objects; the caller adds the submission's.
  SuiteJob study(const std::filesystem::path& folder) const;

  // The suite and its worker run on one processor, another one for each thread that calls this. Both throw
  // std::runtime_error if the suite itself fails.
  SuiteResult run(const SuiteJob& job, ExerciseTiming& timing) const;
  SuiteResult run_study(const SuiteJob& job, ExerciseTiming& timing) const;

 private:
  Budget share() const;
  SuiteJob job(const std::string& exercise, const std::filesystem::path& folder) const;
  std::optional<WholeRunJob> whole_run(const std::string& exercise) const;

  const GradingSettings& settings_;
  const StagedKit& kit_;
  std::string suite_hash_, drawn_;
  std::optional<std::filesystem::path> pictures_;  // is the folder of the reference's pictures, if any
  TimingByExercise reference_;
  mutable Processors processors_;  // has a lock of its own
};

}  // namespace grader::grading
