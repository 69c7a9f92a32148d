// STAFF ONLY. H5's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h5 {

std::vector<Category> categories();

}  // namespace grader::h5
