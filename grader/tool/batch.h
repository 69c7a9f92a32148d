// STAFF ONLY. Many submissions, side by side: each is graded and its reports are written at once, so that a
// batch that is interrupted leaves what is finished. One submission's failure stops no other.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/report/result.h"
#include "grader/tool/grading.h"

namespace grader {

struct BatchSettings {
  std::filesystem::path out;
  int jobs = 1;
  bool resume = false;              // keep results whose fingerprint has not changed
  std::optional<std::string> only;  // grade this submission alone; others' results are kept as they are
  bool merge = false;               // an exercise alone is graded: keep the earlier results of the others
};

struct Batch {
  std::vector<SubmissionResult> results;  // sorted by name; those that there are
  int graded = 0, kept = 0;
  std::vector<std::string> problems;  // ours: what could not be graded, a line each
  bool interrupted = false;
};

// `interrupted` is set from outside (Ctrl-C) and ends the batch after nothing more is begun. Throws BadInput
// for an `only` that names none of the submissions, and for a folder that can't be written.
Batch grade_batch(const Grading& grading, const std::vector<Submission>& submissions,
                  const BatchSettings& settings, const std::atomic<bool>& interrupted);

}  // namespace grader
