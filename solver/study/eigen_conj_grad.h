// Eigen's conjugate gradients behind ConjGrad's interface: no preconditioner, the same operator, first guess
// and stopping rule.
#pragma once

#include "solver/linearSolver.h"

namespace solver::study {

// As ConjGrad, but ends when ||b - Ax|| < tolerance ||b||.
void eigen_conj_grad(int n, implicitMatrix* A, double x[], double b[], double tolerance, int* steps);

}  // namespace solver::study
