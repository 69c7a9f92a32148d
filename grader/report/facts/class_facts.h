// STAFF ONLY. The facts on a class's page beside results: people on the roster, files left over, the end of
// the last run, late hand-ins.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/archives/accounted.h"
#include "grader/result/costs.h"
#include "grader/result/lateness.h"
#include "grader/result/study.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

struct ClassFacts {
  std::vector<ClassLine> people = {};  // see grades_csv
  std::vector<Accounted> listed = {};
  std::optional<LastRun> run = {};
  std::string due = {};                                               // "": there is no date
  std::map<std::string, Lateness> late = {};                          // by the hand-in's name
  std::vector<std::pair<std::string, SubmissionStudy>> studies = {};  // by the name of the hand-in
  bool is_public = false;  // true: it links to students' reports alone, and shows nothing of the staff
};

}  // namespace grader::report
