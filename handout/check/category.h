// The categories of an exercise's points, as its categories.json declares them: cmake/categories.cmake makes initializers of them.
#pragma once

#include <string>
#include <vector>

namespace checks {

// What a failure may come from.
struct Row {
  std::string id, see, look;
};

struct Category {
  std::string id, title;  // "Velocities", "Pass 1: velocities"
  double points = 0;
  std::vector<std::string> functions;  // that it asks; none: it is asked in grading alone
  std::vector<Row>
      rows;  // a failure points to the first, unless its check names another (look_at in check.h)
};

}  // namespace checks
