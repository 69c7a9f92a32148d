// STAFF ONLY. H2's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h2 {

std::vector<Category> categories();

}  // namespace grader::h2
