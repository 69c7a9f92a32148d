// STAFF ONLY. Cases of H8 that stand in files of their own.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h8 {

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void functions(Trial& trial);
void nearly_straight(Trial& trial);
void centre_line(Trial& trial);
void carried_frames(Trial& trial);
void stiffness(Trial& trial);
void elasticity(Trial& trial);
void jacobians(Trial& trial);
void winding(Trial& trial);
void forces(Trial& trial);
void masses(Trial& trial);
void bare_elements(Trial& trial);
void steps(Trial& trial);
void stiff_steps(Trial& trial);
void other_units(Trial& trial);

}  // namespace grader::h8
