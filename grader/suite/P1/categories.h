// STAFF ONLY. P1's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::p1 {

std::vector<Category> categories();

}  // namespace grader::p1
