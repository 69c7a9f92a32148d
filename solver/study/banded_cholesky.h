// Solves Ax = b by elimination for a banded A: A = LL', where L has the same bandwidth as A's lower half. A
// strand's matrix has 3 entries below the diagonal. O(n w^2) work once, O(n w) for each b. Source: Golub and
// Van Loan, "Matrix Computations", 4th edition, section 4.3.5.
#pragma once

#include <vector>

#include "solver/matrices.h"

namespace solver::study {

class BandedCholesky {
 public:
  // A is symmetric and positive definite; only its lower half is read. Throws std::invalid_argument if A is
  // not square or not positive definite.
  explicit BandedCholesky(const SparseMatrix& A);

  int width() const { return width_; }  // the number of diagonals below the main one

  // Computes L with L L' = A from the entries that the constructor read. The study times this function.
  void factor();

  void solve(double x[]) const;  // x = A^-1 x

 private:
  double& at(std::vector<double>& band, int row, int column) const {
    return band[static_cast<std::size_t>(row) * (width_ + 1) + (column - row + width_)];
  }
  double at(const std::vector<double>& band, int row, int column) const {
    return band[static_cast<std::size_t>(row) * (width_ + 1) + (column - row + width_)];
  }

  int n_, width_ = 0;
  std::vector<double> matrix_, factor_;  // row i: columns i - width .. i
};

}  // namespace solver::study
