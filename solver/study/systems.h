// Systems Ax = b for studying a solver: symmetric, positive definite, with a known solution and known
// eigenvalues.
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

// The largest eigenvalue of the two systems below. It is not 1: the first guess is b, so the part of the
// solution that belongs to an eigenvalue of 1 would be right from the start. As |1 - eigenvalue| <= 1, the
// first residual is no longer than b.
inline constexpr double kLargestEigenvalue = 2;

// Eigenvalues with evenly spaced logarithms, so that there are no clusters.
System spread_system(int n, double condition);

// Eigenvalues at `clusters` >= 2 places with evenly spaced logarithms, n / clusters at each place.
System clustered_system(int n, double condition, int clusters);

// An implicit Euler step of `step` seconds for a model of a hair: 30 cm long, with `segments` segments,
// straight and clamped, with springs along it and across it between neighbours. (Bending as in exercise H2
// couples particles two apart, which makes the band 8 wide instead of 3.) It has 3 * segments unknowns; its
// condition number grows with step^2 EA / (l m).
System strand_system(int segments, double step);

// The same matrix as a SparseMatrix.
SparseMatrix strand_matrix(int segments, double step);

// The numbers of a strand of human hair with `segments` springs (C. R. Robbins, "Chemical and Physical
// Behavior of Human Hair", 5th edition, 2012, chapter 9).
struct StrandNumbers {
  double mass;     // kg, of a particle
  double stretch;  // N/m, EA / l
  double bend;     // N/m, EI / l^3: of a spring across, as stiff as a bending beam segment
};
StrandNumbers strand_numbers(int segments);

// Pseudo-random numbers in (-1, 1), the same for the same seed.
Vector scattered(int n, unsigned seed);

double squared_norm(const Vector& x);
double energy_norm(implicitMatrix& A, Vector x);  // sqrt(x'Ax)
Vector difference(const Vector& a, const Vector& b);
Vector product(implicitMatrix& A, Vector x);

}  // namespace solver::study
