// What the solver's study calls of the exercises.
#pragma once

#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// Those that the course has; the others are empty.
solver::study::Functions studied_functions();

// There if the course has the normal equations.
extern const solver::study::NormalEquationsFunction kNormalEquations;

}  // namespace hair::solver_lab
