// STAFF ONLY. Cases of H4 that stand in files of their own: those of solve_plain, which gets a matrix of ours.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h4 {

void expect_same_solve_in_other_units(Trial& trial);

}  // namespace grader::h4
