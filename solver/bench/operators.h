// Matrices for timing a solver. Each is given by a formula, so a product reads x, writes b, and touches
// almost no other memory.
#pragma once

#include <vector>

#include "solver/linearSolver.h"

namespace solver_bench {

// M + h^2 K of an implicit Euler step of a hair: block-tridiagonal, with 3 x 3 blocks that are multiples of
// the identity, since the springs pull equally in all directions. 3 `particles` unknowns, at least 2
// particles; `spring` is h^2 k / m.
class StrandOperator : public implicitMatrix {
 public:
  StrandOperator(int particles, double spring) : n_(3 * particles), spring_(spring) {}
  void matVecMult(double x[], double b[]) override;

 private:
  int n_;
  double spring_;
};

// The five-point Laplacian on a `side` x `side` grid with zero boundary values, side >= 2.
class PoissonOperator : public implicitMatrix {
 public:
  explicit PoissonOperator(int side) : side_(side), boundary_(side, 0.0) {}
  void matVecMult(double x[], double b[]) override;

 private:
  int side_;
  std::vector<double> boundary_;  // the zeros above the first row and below the last row
};

}  // namespace solver_bench
