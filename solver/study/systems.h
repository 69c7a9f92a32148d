// Systems Ax = b to watch a solver on: symmetric, positive definite, with a solution and a spectrum that are
// known.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/matrices.h"

namespace solver::study {

using Vector = std::vector<double>;

struct System {
  std::string name;
  std::shared_ptr<implicitMatrix> matrix;
  double largest = 1, smallest = 1;  // eigenvalues
  Vector solution, right_side;

  int n() const { return static_cast<int>(solution.size()); }
  double condition() const { return largest / smallest; }
};

// The largest eigenvalue of the two below. The first guess is b, so that an eigenvalue of 1 would have its
// part of the solution for nothing; and as |1 - eigenvalue| <= 1, the first residual is no longer than b.
inline constexpr double kLargestEigenvalue = 2;

// Eigenvalues whose logarithms are evenly spaced: no two of them help each other.
System spread_system(int n, double condition);

// Eigenvalues in `clusters` >= 2 places whose logarithms are evenly spaced, n / clusters in each.
System clustered_system(int n, double condition, int clusters);

// A step of `step` seconds of implicit Euler of a model of a hair: 30 cm long, in so many segments, straight
// and clamped, springs along it and across it between neighbours. (Bending as in exercise H2 reaches two
// particles far, and makes the band 8 wide instead of 3.) Its unknowns are 3 segments, its condition number
// grows with step^2 EA / (l m).
System strand_system(int segments, double step);

// The same as a matrix in rows: SparseMatrix entries.
SparseMatrix strand_matrix(int segments, double step);

// What a strand is made of: human hair (C. R. Robbins, "Chemical and Physical Behavior of Human Hair", 5th
// edition, 2012, chapter 9), for `segments` springs.
struct StrandNumbers {
  double mass;     // kg, of a particle
  double stretch;  // N/m, EA / l
  double bend;     // N/m, EI / l^3: of a spring across, as stiff as a segment of a beam that bends
};
StrandNumbers strand_numbers(int segments);

// Numbers in (-1, 1) with no pattern, the same for the same seed.
Vector scattered(int n, unsigned seed);

double squared_norm(const Vector& x);
double energy_norm(implicitMatrix& A, Vector x);  // sqrt(x'Ax)
Vector difference(const Vector& a, const Vector& b);
Vector product(implicitMatrix& A, Vector x);

}  // namespace solver::study
