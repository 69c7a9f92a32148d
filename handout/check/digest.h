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
  std::string program;   // its path
  std::vector<Category> categories;
};

// The row with the id that a check names ("-": no row). Null if the category has none of this id.
const Row* row_of(const Category& category, const std::string& row);

// At most fifteen lines. With `full`: all failures, each whole, and all categories.
std::string digest(const Asked& asked, const std::vector<Finding>& findings, bool full);

}  // namespace checks
