// STAFF ONLY. S2's categories; each sends its cases to the student's functions and throws CaseFailed at the
// first that fails.
#pragma once

#include "grader/suite/trial.h"

namespace grader::s2 {

void table(Trial& trial);
void normal_operator(Trial& trial);
void non_symmetric(Trial& trial);
void indefinite(Trial& trial);
void least_squares(Trial& trial);
void steps_and_products(Trial& trial);

}  // namespace grader::s2
