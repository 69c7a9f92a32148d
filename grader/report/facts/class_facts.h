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
#include "grader/result/result.h"
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

// A course with several hand-ins: each person's points in each of them.
struct CourseTable {
  struct Cell {
    double points = 0, max_points = 0;
    double extra_credit = 0;  // among the points
  };
  struct HandIn {
    std::string name, folder;                        // are its pages' name and folder, below the course's
    double extra_credit_share = 0, total_share = 0;  // limit both to this share of the full points
    double max_points = 0;                           // is the most that a person can reach
  };
  struct Row {
    std::string name;
    std::vector<std::optional<Cell>> cells;  // has one for each hand-in; empty: no hand-in
  };
  std::vector<HandIn> hand_ins;
  std::vector<Row> rows;

  // A missing hand-in counts as no points of its maximum. Extra credit counts up to the shares of all
  // hand-ins together: a hand-in that has nothing else adds no more.
  Cell total(const Row& row) const;
};

}  // namespace grader::report
