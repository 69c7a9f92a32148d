// STAFF ONLY. A course with several hand-ins: what each person has in each of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grader::inline report {

struct CourseTable {
  struct Cell {
    double points = 0, max_points = 0;
  };
  struct HandIn {
    std::string name, folder;  // of its pages, beside the course's
    double max_points = 0;     // the most that anybody can reach
  };
  struct Row {
    std::string name;
    std::vector<std::optional<Cell>> cells;  // one for each hand-in; nothing: nothing handed in
  };
  std::vector<HandIn> hand_ins;
  std::vector<Row> rows;

  // A hand-in that is missing counts with no points of its most.
  Cell total(const Row& row) const;
};

}  // namespace grader::report
