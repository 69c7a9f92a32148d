// STAFF ONLY. H1's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h1 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{1, 3};

}  // namespace grader::h1
