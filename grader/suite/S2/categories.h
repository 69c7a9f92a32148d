// STAFF ONLY. S2's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::s2 {

std::vector<Category> categories();

}  // namespace grader::s2
