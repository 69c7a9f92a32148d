// STAFF ONLY. H1's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h1 {

std::vector<Category> categories();

}  // namespace grader::h1
