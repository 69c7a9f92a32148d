// STAFF ONLY. Cases of H5 that stand in files of their own.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h5 {

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void relaxation(Trial& trial);
void relaxation_masses(Trial& trial);
void lengths(Trial& trial);
void impulses(Trial& trial);
void masses(Trial& trial);
void distance(Trial& trial);
void root(Trial& trial);
void report(Trial& trial);
void velocities(Trial& trial);
void velocity_impulses(Trial& trial);
void degenerate(Trial& trial);
void long_strands(Trial& trial);

}  // namespace grader::h5
