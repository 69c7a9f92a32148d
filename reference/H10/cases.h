// STAFF ONLY. The part of H10's cases in other units that is about weights.
#pragma once

#include "grader/judge/cases/trial.h"

namespace grader::h10 {

void weights_in_other_units(Trial& trial);

}  // namespace grader::h10
