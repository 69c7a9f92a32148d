// STAFF ONLY. The table of hidden suites: of each exercise its categories() and, where it has a scene.json, its whole_run(), the points
// of that run. Both stand in grader/exercise/<ID>/cases.cpp.
#pragma once

#include <string>
#include <vector>

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader {

// Both throw BadInput for an exercise without a suite.
std::vector<Category> categories(const std::string& exercise);
WholeRunPoints whole_run_points(const std::string& exercise);

}  // namespace grader
