// STAFF ONLY. Grades many submissions in parallel. Each result goes into the class's record as soon as it is
// there, so that an interrupted batch leaves the finished ones. A failure in one submission does not affect
// others. All files are made from the record, whoever graded.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/record/rules.h"
#include "grader/result/result.h"
#include "grader/roster/roster.h"
#include "grader/tool/grading.h"
#include "grader/tool/origins.h"

namespace grader::inline tool {

struct BatchSettings {
  std::filesystem::path out;
  int jobs = 1;
  bool resume = false;                 // keep results whose fingerprint has not changed
  std::optional<std::string> only;     // grade only this submission
  CallersWord word = {};               // about rows that may be replaced
  std::optional<Roster> roster;        // replaces the record's
  bool blind = false;                  // names are codes; a record that began so stays so
  std::vector<Accounted> listed = {};  // files of the input that reached no hand-in
  std::string hand_in = {};            // its name in the record, "" where the course has one
  HandInRules rules = {};              // of the course file: lateness, and how much extra credit counts
  bool merge = false;                  // only one exercise is graded: keep the earlier results of the others
};

struct Batch {
  std::vector<SubmissionResult> results;  // all that the record holds, sorted by name
  int graded = 0, kept = 0;               // by this batch; from before
  std::size_t done = 0;                   // of the submissions that were asked for: graded, or found done
  std::vector<std::string> problems;      // on our side: what could not be graded, a line each
  std::vector<std::string> conflicts;     // decisions of people against other points than now, a line each
  std::vector<std::string> remarks;       // times of hand-ins that are others than before, a line each
  bool interrupted = false;
  bool began = true;  // false: interrupted while another process had the folder
};

// Waits while another process grades into the same folder. When `interrupted` is set from outside (Ctrl-C),
// the batch starts nothing new and ends. Throws BadInput for an `only` that names none of the submissions, as
// FolderOfGrades::open does, and as settle_origins does.
Batch grade_batch(const Grading& grading, std::vector<Submission> submissions, const BatchSettings& settings,
                  const std::atomic<bool>& interrupted);

}  // namespace grader::tool
