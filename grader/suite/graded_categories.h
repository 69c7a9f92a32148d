// STAFF ONLY. All categories that an exercise is graded by, with the points of each.
#pragma once

#include <string>
#include <vector>

#include "grader/suite/trial.h"

namespace grader {

// The hidden cases, the whole run, its pictures, and memory errors: as graded where nothing is left out. Those after the cases can't
// be run from here. Throws BadInput for an exercise without a suite.
std::vector<Category> graded_categories(const std::string& exercise);

}  // namespace grader
