// STAFF ONLY. P2's categories.
#pragma once

#include "grader/suite/trial.h"

namespace grader::p2 {

std::vector<Category> categories();

}  // namespace grader::p2
