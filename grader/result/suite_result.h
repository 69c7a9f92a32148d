// STAFF ONLY. The results of a hidden suite for a job (grader/judge/job.h), as hairsuite writes them to
// standard output.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/budget.h"
#include "grader/result/result.h"
#include "grader/result/study.h"

namespace grader::inline result {

// This is a key of SuiteResult::reproduced, with a sentence in place of files: why a case can't be written.
inline constexpr const char* kNotReproduced = "not reproduced";

struct SuiteResult {
  std::vector<CaseResult> cases;         // belong to an exercise; points are weights, not yet its points
  std::vector<PictureResult> pictures;   // show its whole run
  RunMotions motions;                    // the same
  std::optional<SubmissionStudy> study;  // is set for "study"
  double cpu_seconds = 0;                // is the worker's
  double run_cpu_seconds = 0;            // is the worker's in the whole run
  double picture_cpu_seconds = 0;        // on our side: drawing and comparing
  int starts = 0;                        // counts the worker's
  Budget spent = nothing_spent();
  std::map<std::string, std::string> reproduced = {};  // files by name (grader/judge/reproduction.h)

  bool operator==(const SuiteResult&) const = default;
};

}  // namespace grader::result
