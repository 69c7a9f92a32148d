// STAFF ONLY. Cases of H7 that stand in files of their own.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h7 {

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void velocities(Trial& trial);
void moving_joints(Trial& trial);
void link_forces(Trial& trial);
void inertias(Trial& trial);
void biases(Trial& trial);
void added_by_steps(Trial& trial);
void accelerations(Trial& trial);
void trees(Trial& trial);
void long_chains(Trial& trial);
void other_units(Trial& trial);
void values_before(Trial& trial);
void spherical_joints(Trial& trial);

}  // namespace grader::h7
