// STAFF ONLY. H6's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h6 {

std::vector<Category> categories();

}  // namespace grader::h6
