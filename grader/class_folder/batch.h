// STAFF ONLY. Grades many submissions in parallel. Each result goes into the class's record at once, so that
// an interrupted batch leaves the finished ones. A failure in one submission does not affect others. All
// files are made from the record, also from results of other runs.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
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

// Grades hand-ins, or has what others graded.
struct Grader {
  Course course;
  TimingByExercise reference;
  std::string made_by;  // is JSON of grading/made_by.h
  bool studies = false;
  std::function<std::string(const Submission&)> fingerprint;
  std::function<std::optional<Graded>(const Submission&)> grade;  // returns nothing for one that is to come
  std::function<void(const Submission&, Graded&)> grade_again;
};
Grader grader_here(const Grading& grading);  // keeps a reference to it

// Puts the plan's people into the record. Each submission gets the name that its inputs are drawn from.
void enter_plan(Plan& plan, const BatchSettings& settings, Record& record);

// Carries a plan out that is in the record `current` of its folder. When `interrupted` is set from outside
// (Ctrl-C), the batch starts nothing new and ends. Throws BadInput if the folder can't be written.
Batch grade_batch(const Grader& grader, Plan plan, const BatchSettings& settings, Record& current,
                  const std::atomic<bool>& interrupted);

}  // namespace grader::class_folder
