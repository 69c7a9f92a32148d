// STAFF ONLY. H3's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h3 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{1, 1};

}  // namespace grader::h3
