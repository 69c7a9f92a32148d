// STAFF ONLY. P1's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::p1 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{1, 2};

}  // namespace grader::p1
