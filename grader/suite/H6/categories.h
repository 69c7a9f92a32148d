// STAFF ONLY. H6's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h6 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{2, 4};

}  // namespace grader::h6
