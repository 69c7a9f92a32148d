#include "hair/lab/solver/functions.h"
#include "solver/normal_equations.h"

namespace hair::solver_lab {

const solver::study::NormalEquationsFunction kNormalEquations = solve_normal_equations;

}  // namespace hair::solver_lab
