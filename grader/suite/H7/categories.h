// STAFF ONLY. H7's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h7 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{};  // no scene calls it

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void velocities(Trial& trial);
void moving_joints(Trial& trial);
void link_forces(Trial& trial);
void inertias(Trial& trial);
void biases(Trial& trial);
void gains(Trial& trial);
void accelerations(Trial& trial);
void equations_of_motion(Trial& trial);
void trees(Trial& trial);
void long_chains(Trial& trial);
void spherical_joints(Trial& trial);

}  // namespace grader::h7
