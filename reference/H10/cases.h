// STAFF ONLY. What the weights add to H10's cases in other units.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h10 {

void weights_in_other_units(Trial& trial);

}  // namespace grader::h10
