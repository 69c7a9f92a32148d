// STAFF ONLY. Some of H2's categories; see categories.cpp.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h2 {

void clamped_root(Trial& trial);
void nearly_straight(Trial& trial);
void straight_products(Trial& trial);
void fold(Trial& trial);
void no_direction(Trial& trial);
void extremes(Trial& trial);

}  // namespace grader::h2
