// STAFF ONLY. H5's categories.
#pragma once

#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h5 {

std::vector<Category> categories();

inline constexpr WholeRunPoints kWholeRun{2, 3};

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
