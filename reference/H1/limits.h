// STAFF ONLY. H1's categories of rare strands; see cases.cpp.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h1 {

void no_direction(Trial& trial);
void extremes(Trial& trial);

}  // namespace grader::h1
