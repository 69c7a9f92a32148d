// STAFF ONLY. H3's categories of rare strands; see cases.cpp.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h3 {

void every_spring(Trial& trial);
void no_direction(Trial& trial);

}  // namespace grader::h3
