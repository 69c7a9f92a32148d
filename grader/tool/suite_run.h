// STAFF ONLY. Runs the hidden suite as a separate program, with a job as input and the results as output. See
// grader/suite/main.cpp.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/budget.h"
#include "grader/result/result.h"
#include "grader/result/study.h"

namespace grader {

struct SuiteJob {
  std::string exercise;  // or "runs", or "study"
  std::string seed;
  std::filesystem::path kit;
  std::vector<std::string> provided;           // exercises whose functions the suite provides
  std::vector<std::filesystem::path> objects;  // in loading order
  std::filesystem::path log;
  bool isolated = true;
  int cpu_seconds = 10;
  Budget allowance = {};
  bool count_cases = true;  // of wrong categories, how many of their cases hold
  std::optional<std::filesystem::path> pictures =
      {};  // the folder of the reference's pictures; nothing: none are drawn

  // The student's object with sanitizers; empty: there is none. Nothing: memory errors are not looked for.
  std::optional<std::filesystem::path> sanitised = {};

  // For an exercise with a whole run, see grader/suite/whole_run.h.
  struct WholeRun {
    std::filesystem::path scene;
    std::string seed;
    std::filesystem::path player;  // see grader/play/play.h
    int cpu_seconds = 10;
  };
  std::optional<WholeRun> whole_run = {};

  // Only for "runs" and "study", see grader/suite/end_to_end.h.
  std::vector<std::string> left_out = {};
  std::map<std::string, std::string> unavailable = {};

  // Only for "study", see grader/suite/study/submission_study.h.
  std::vector<std::filesystem::path> reference_objects = {};
  std::filesystem::path motions = {};  // the folder of true motions
};

struct SuiteResult {
  std::vector<RunResult> runs;           // of "runs"
  std::optional<SubmissionStudy> study;  // of "study"
  std::vector<CaseResult> cases;         // points are weights, not yet scaled to the exercise's points
  std::vector<PictureResult> pictures;
  // A memory error, as a sentence for the student, and where in the sanitised object it is, see
  // grader/wire/memory_error.h: not trusted. Empty: none was found.
  struct {
    std::string told;
    std::vector<std::uint64_t> offsets;
  } memory_error;
  int allocations = 0;               // see Student::allocations
  double cpu_seconds = 0;            // of the worker
  double sanitised_cpu_seconds = 0;  // of the worker with sanitizers
  double run_cpu_seconds = 0;        // of the worker that played the whole run
  double picture_cpu_seconds = 0;    // on our side: drawing and comparing
  int starts = 0;
  Budget spent = nothing_spent();
};

// Throws std::runtime_error if the suite itself fails.
SuiteResult run_suite(const std::filesystem::path& suite, const SuiteJob& job);

}  // namespace grader
