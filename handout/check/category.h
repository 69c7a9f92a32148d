// The categories of an exercise's points, as its categories.json declares them: cmake/categories.cmake makes
// initializers of them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace checks {

// A cause of failures, and where to look for it.
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

// The category of a test suite: it has its id, or, of a suite with parameters, "Midpoint/Integrator", one of
// its parts has it. Null: there is none.
inline const Category* category_of(const std::vector<Category>& categories, const std::string& suite) {
  const std::size_t stroke = suite.rfind('/');
  const auto found = std::ranges::find(categories, suite.substr(stroke + 1), &Category::id);  // npos + 1 is 0
  if (found != categories.end()) return &*found;
  return stroke == std::string::npos ? nullptr : category_of(categories, suite.substr(0, stroke));
}

}  // namespace checks
