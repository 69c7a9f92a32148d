// STAFF ONLY. H3's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h3 {

std::vector<Category> categories();

}  // namespace grader::h3
