// STAFF ONLY. What solve_plain adds to H4's cases in other units.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h4 {

void expect_same_solve_in_other_units(Trial& trial);

}  // namespace grader::h4
