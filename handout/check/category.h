// The categories of an exercise's points, as its categories.json declares them: cmake/categories.cmake makes
// initializers of them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace checks {

// A cause of failures, and where to look for it.
struct Row {
  std::string id, look;             // without a look: no place is likelier than others
  std::vector<std::string> checks;  // failures of these point here; those of all others, to the first row
};

struct Category {
  std::string id, title;  // "Velocities", "Pass 1: velocities"
  double points = 0;
  std::vector<std::string> functions;  // its checks call these; empty if only grading has its checks
  std::vector<Row> rows;
};

// The category whose id is the name of this test suite. A suite with parameters, "Midpoint/Integrator", has
// the id as one part of its name. Null if no category has it.
inline const Category* category_of(const std::vector<Category>& categories, const std::string& suite) {
  const std::size_t stroke = suite.rfind('/');
  const auto found = std::ranges::find(categories, suite.substr(stroke + 1), &Category::id);  // npos + 1 is 0
  if (found != categories.end()) return &*found;
  return stroke == std::string::npos ? nullptr : category_of(categories, suite.substr(0, stroke));
}

}  // namespace checks
