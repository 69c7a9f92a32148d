// STAFF ONLY. H4's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h4 {

std::vector<Category> categories();

void preconditioned(Trial& trial);

inline constexpr WholeRunPoints kWholeRun{2, 3};

}  // namespace grader::h4
