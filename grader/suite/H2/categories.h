// STAFF ONLY. H2's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h2 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{2, 3};

}  // namespace grader::h2
