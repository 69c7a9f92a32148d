// S2: the normal equations. The contract is in solver/normal_equations.h, the text in
// exercises/S2/text.md.

#include "solver/normal_equations.h"

#include "solver/not_implemented.h"

std::unique_ptr<implicitMatrix> dense_matrix(int /*rows*/, int /*cols*/, const double /*a*/[]) {
  throw NotImplemented("S2 dense_matrix");
}

std::unique_ptr<implicitMatrix> normal_matrix(int /*rows*/, int /*cols*/, implicitMatrix* /*A*/,
                                              implicitMatrix* /*A_transposed*/) {
  throw NotImplemented("S2 normal_matrix");
}

double solve_normal_equations(int /*rows*/, int /*cols*/, implicitMatrix* /*A*/,
                              implicitMatrix* /*A_transposed*/, double /*x*/[], double /*b*/[],
                              double /*epsilon*/, int* /*steps*/) {
  throw NotImplemented("S2 solve_normal_equations");
}
