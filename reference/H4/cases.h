// STAFF ONLY. The part of H4's cases in other units that is about solve_plain.
#pragma once

#include "grader/judge/cases/trial.h"

namespace grader::h4 {

void expect_same_solve_in_other_units(Trial& trial);

}  // namespace grader::h4
