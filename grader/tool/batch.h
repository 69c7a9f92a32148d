// STAFF ONLY. Grades many submissions in parallel. Each result goes into the class's record as soon as it is
// there, so that an interrupted batch leaves the finished ones. A failure in one submission does not affect
// others. All files are made from the record, whoever graded.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "grader/result/result.h"
#include "grader/tool/grading.h"
#include "grader/tool/plan.h"

namespace grader::inline tool {

struct Batch {
  std::vector<SubmissionResult> results;  // all that the record holds, sorted by name
  int graded = 0, kept = 0;               // by this batch; from before
  std::size_t done = 0;                   // of the submissions that were asked for: graded, or found done
  std::vector<std::string> problems;      // on our side: what could not be graded, a line each
  std::vector<std::string> conflicts;     // decisions of people against other points than now, a line each
  std::vector<std::string> remarks;       // times of hand-ins that are others than before, a line each
  bool interrupted = false;
};

// Carries a plan out, in the folder that it was made for. When `interrupted` is set from outside (Ctrl-C),
// the batch starts nothing new and ends. Throws BadInput if the folder can't be written.
Batch grade_batch(const Grading& grading, Plan plan, const BatchSettings& settings, Record& record,
                  const std::atomic<bool>& interrupted);

}  // namespace grader::tool
