// The findings of an exercise's checks, for a terminal: the first failure in full, the others by name, the
// categories at stake.
#pragma once

#include <string>
#include <vector>

#include "category.h"
#include "finding.h"

namespace checks {

struct Asked {
  std::string exercise;  // "H2"
  std::string program;   // that was started
  std::vector<Category> categories;
};

// The row of its category that a check points to, or "-"; null: there is none.
const Row* row_of(const Category& category, const std::string& row);

// At most fifteen lines. With `full`: all failures, each whole, and all categories.
std::string digest(const Asked& asked, const std::vector<Finding>& findings, bool full);

}  // namespace checks
