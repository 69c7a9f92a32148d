// STAFF ONLY. What a hidden suite found of a job (grader/judge/job.h), as hairsuite writes it to standard
// output.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/budget.h"
#include "grader/result/result.h"
#include "grader/result/study.h"

namespace grader::inline result {

// The look for memory errors, see grader/judge/memory_errors.h.
struct MemoryLook {
  // A memory error, as a sentence for the student, and the number of the function that was called, in the
  // order of exercises.json. Empty: none was found.
  std::string message;
  int call = -1;
  double cpu_seconds = 0;  // of the worker with sanitizers

  bool operator==(const MemoryLook&) const = default;
};

struct SuiteResult {
  std::vector<CaseResult> cases;         // of an exercise; points are weights, not yet scaled to its points
  std::vector<PictureResult> pictures;   // of its whole run
  std::optional<SubmissionStudy> study;  // of "study"
  std::optional<MemoryLook> memory;      // nothing: not looked for
  double cpu_seconds = 0;                // of the worker
  double run_cpu_seconds = 0;            // of the worker that played the whole run
  double picture_cpu_seconds = 0;        // on our side: drawing and comparing
  int starts = 0;                        // of the worker
  Budget spent = nothing_spent();

  bool operator==(const SuiteResult&) const = default;
};

}  // namespace grader::result
