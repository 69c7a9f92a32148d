// STAFF ONLY. S2's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::s2 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{};  // no scene calls it

}  // namespace grader::s2
