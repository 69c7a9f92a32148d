// STAFF ONLY. Grades many submissions in parallel. Each result goes into the class's record at once, so that
// an interrupted batch leaves the finished ones. A failure in one submission does not affect others. All
// files are made from the record, also from results of other runs.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "grader/class_folder/plan.h"
#include "grader/grading/grading.h"
#include "grader/result/result.h"

namespace grader::inline class_folder {

struct Batch {
  std::vector<SubmissionResult> results;  // are all results in the record, sorted by name
  int graded = 0, kept = 0;               // count results of this batch, and older ones
  std::size_t done = 0;                   // counts requested submissions that are graded, or were done
  std::vector<std::string> problems;      // on our side: a line for each failure to grade
  std::vector<std::string> conflicts;     // a line for each decision of a person on other points than now
  std::vector<std::string> remarks;       // a line for each hand-in whose time has changed
  bool interrupted = false;
  bool staged = false;                // a regrade has not ended: all files show the results before it
  std::vector<std::string> ungraded;  // are the hand-ins that it waits for, if it was not interrupted
};

// Carries a plan out, in the folder that it was made for, whose record is `current`. When `interrupted` is
// set from outside (Ctrl-C), the batch starts nothing new and ends. Throws BadInput if the folder can't be
// written.
Batch grade_batch(const Grading& grading, Plan plan, const BatchSettings& settings, Record& current,
                  const std::atomic<bool>& interrupted);

}  // namespace grader::class_folder
