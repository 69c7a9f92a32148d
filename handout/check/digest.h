// The findings of an exercise's checks, for a terminal: the first failure in full, the others by name, the
// categories at stake.
#pragma once

#include <string>
#include <vector>

#include "apart.h"
#include "category.h"

namespace checks {

struct Asked {
  std::string exercise;  // "H2"
  std::string program;   // its path
  std::vector<Category> categories;
};

// At most fifteen lines. With `full`: all failures, each whole, and all categories.
std::string digest(const Asked& asked, const std::vector<Finding>& findings, bool full);

}  // namespace checks
