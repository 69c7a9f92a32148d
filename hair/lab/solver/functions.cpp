#include "hair/lab/solver/functions.h"

#include "solver/course.h"
#include "solver/linearSolver.h"

namespace hair::solver_lab {

solver::study::Functions studied_functions() {
  solver::study::Functions all;
  if constexpr (in_course("S1")) all.conj_grad = ConjGrad;
  if constexpr (in_course("S2")) all.normal_equations = kNormalEquations;
  return all;
}

}  // namespace hair::solver_lab
