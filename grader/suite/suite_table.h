// STAFF ONLY. The table of hidden suites: one folder for each exercise, grader/suite/H1/ and so forth.
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
