// Solving Ax = b by elimination where A has entries near its diagonal only: A = LL', L as narrow as A's lower
// half. What a strand's matrix is: 3 below the diagonal. O(n w^2) work once, O(n w) for each b. Source: Golub
// and Van Loan, "Matrix Computations", 4th edition, section 4.3.5.
#pragma once

#include <vector>

#include "solver/matrices.h"

namespace solver::study {

class BandedCholesky {
 public:
  // A is symmetric and positive definite; its lower half is read. Throws std::invalid_argument if it is not
  // square, or not positive definite.
  explicit BandedCholesky(const SparseMatrix& A);

  int size() const { return n_; }
  int width() const { return width_; }  // how far below the diagonal entries are

  // L L' = A, from the entries that the constructor read: what is timed.
  void factor();

  // x = A^-1 x.
  void solve(double x[]) const;

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
