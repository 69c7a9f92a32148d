// The exercises' functions that the solver study calls.
#pragma once

#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// The functions of the course's exercises; the others are empty.
solver::study::Functions studied_functions();

// Defined only if the course has the normal equations.
extern const solver::study::NormalEquationsFunction kNormalEquations;

}  // namespace hair::solver_lab
