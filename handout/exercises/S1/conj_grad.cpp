// S1: the method of conjugate gradients. The contract is in solver/linearSolver.h, the text in
// exercises/S1/text.md.

#include "solver/linearSolver.h"
#include "solver/not_implemented.h"

double ConjGrad(int /*n*/, implicitMatrix* /*A*/, double /*x*/[], double /*b*/[], double /*epsilon*/,
                int* /*steps*/) {
  throw NotImplemented("S1 ConjGrad");
}
