// STAFF ONLY. A course with several hand-ins: each person's points in each of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grader::inline report {

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
