// STAFF ONLY. Cases of H5 that stand in files of their own.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h5 {

void relaxation(Trial& trial);
void lengths(Trial& trial);
void impulses(Trial& trial);
void velocities(Trial& trial);
void masses(Trial& trial);
void root(Trial& trial);
void report(Trial& trial);
void iterations(Trial& trial);
void degenerate(Trial& trial);
void far_root(Trial& trial);
void units(Trial& trial);
void long_strands(Trial& trial);

}  // namespace grader::h5
