// STAFF ONLY. H4's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h4 {

std::vector<Category> categories();

}  // namespace grader::h4
