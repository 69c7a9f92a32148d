// STAFF ONLY. Grades many submissions in parallel. Each one's reports are written as soon as it is graded, so
// that an interrupted batch leaves the finished ones. A failure in one submission does not affect others.
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
  std::optional<std::string> only;  // grade only this submission; keep the others' results
  bool merge = false;               // only one exercise is graded: keep the earlier results of the others
};

struct Batch {
  std::vector<SubmissionResult> results;  // sorted by name; only those that exist
  int graded = 0, kept = 0;
  std::vector<std::string> problems;  // on our side: what could not be graded, a line each
  bool interrupted = false;
};

// When `interrupted` is set from outside (Ctrl-C), the batch starts nothing new and ends. Throws BadInput for
// an `only` that names none of the submissions, and for a folder that can't be written.
Batch grade_batch(const Grading& grading, const std::vector<Submission>& submissions,
                  const BatchSettings& settings, const std::atomic<bool>& interrupted);

}  // namespace grader
