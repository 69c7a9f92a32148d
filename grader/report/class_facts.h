// STAFF ONLY. The facts on a class's page beside results: people on the roster, files left over, the end of
// the last run, late hand-ins.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/accounted.h"
#include "grader/result/costs.h"
#include "grader/result/lateness.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

struct ClassFacts {
  std::vector<ClassLine> people = {};  // see grades_csv
  std::vector<Accounted> listed = {};
  std::optional<LastRun> run = {};
  std::string due = {};                       // "": there is no date
  std::map<std::string, Lateness> late = {};  // of each hand-in, by name
  bool is_public = false;  // anybody may read it: it leads to students' reports, and to nothing of the staff's
};

}  // namespace grader::report
