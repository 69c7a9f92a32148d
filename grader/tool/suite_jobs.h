// STAFF ONLY. What hidden suites are asked for, and what their answers cost: jobs with their folders, seeds and limits.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/kit.h"
#include "grader/course/course.h"
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

// An exercise by itself, and in the timing all of them end to end, and the same with more steps and fewer.
inline constexpr const char* kRuns = "runs";
inline constexpr const char* kStudy = "study";

class SuiteJobs {
 public:
  // Throws BadInput if `images` asks for pictures and this machine can't draw. Refers to its arguments.
  SuiteJobs(const GradingSettings& settings, const StagedKit& kit);

  const GradingSettings& settings() const { return settings_; }
  const StagedKit& kit() const { return kit_; }

  // All that results depend on: kit, suite, scenes, secret, what draws, the course.
  std::string fingerprint() const;

  // From now on a worker may take a multiple of what the reference took.
  void limit_by(std::map<std::string, ExerciseTiming> reference) { reference_ = std::move(reference); }
  const std::map<std::string, ExerciseTiming>& reference() const { return reference_; }

  bool selected(const Exercise& exercise) const;  // to be graded

  // The cases of an exercise and its whole run, against an object; the reference's are its prerequisites.
  SuiteJob cases(const Exercise& exercise, const std::string& student, const std::filesystem::path& object,
                 const std::filesystem::path& folder) const;

  // All objects together, which are still to be named.
  SuiteJob end_to_end(const std::filesystem::path& folder) const;

  // The same with more steps and fewer, beside a worker that has nothing but the reference's objects.
  SuiteJob study(SuiteJob end_to_end) const;

  std::filesystem::path reference_object(const Exercise& exercise) const;

  SuiteResult run(const SuiteJob& job, ExerciseTiming& timing) const;

 private:
  SuiteJob job(const std::string& exercise, const std::filesystem::path& folder) const;
  std::optional<SuiteJob::WholeRun> whole_run(const std::string& exercise) const;

  const GradingSettings& settings_;
  const StagedKit& kit_;
  std::string suite_hash_, drawn_;
  std::optional<std::filesystem::path> pictures_;  // where the reference's are kept, if any are drawn
  std::map<std::string, ExerciseTiming> reference_;
};

}  // namespace grader
