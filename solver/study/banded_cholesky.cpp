#include "solver/study/banded_cholesky.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace solver::study {

BandedCholesky::BandedCholesky(const SparseMatrix& A) : n_(A.rows()) {
  if (A.rows() != A.cols())
    throw std::invalid_argument("BandedCholesky: a matrix of " + std::to_string(A.rows()) + " x " +
                                std::to_string(A.cols()) + "; it must be square");
  const std::vector<SparseMatrix::Entry> entries = A.entries();
  for (const SparseMatrix::Entry& entry : entries) width_ = std::max(width_, entry.row - entry.col);
  matrix_.assign(static_cast<std::size_t>(n_) * (width_ + 1), 0.0);
  for (const SparseMatrix::Entry& entry : entries)
    if (entry.col <= entry.row) at(matrix_, entry.row, entry.col) = entry.value;
  factor();
}

void BandedCholesky::factor() {
  factor_ = matrix_;
  for (int i = 0; i < n_; ++i) {
    const int first = std::max(0, i - width_);
    for (int j = first; j <= i; ++j) {
      double sum = at(factor_, i, j);
      for (int k = std::max(first, j - width_); k < j; ++k) sum -= at(factor_, i, k) * at(factor_, j, k);
      if (j < i) {
        at(factor_, i, j) = sum / at(factor_, j, j);
      } else if (sum > 0) {
        at(factor_, i, i) = std::sqrt(sum);
      } else {
        throw std::invalid_argument("BandedCholesky: the matrix is not positive definite, as row " +
                                    std::to_string(i) + " shows");
      }
    }
  }
}

void BandedCholesky::solve(double x[]) const {
  for (int i = 0; i < n_; ++i) {
    for (int k = std::max(0, i - width_); k < i; ++k) x[i] -= at(factor_, i, k) * x[k];
    x[i] /= at(factor_, i, i);
  }
  for (int i = n_ - 1; i >= 0; --i) {
    x[i] /= at(factor_, i, i);
    for (int k = std::max(0, i - width_); k < i; ++k) x[k] -= at(factor_, i, k) * x[i];
  }
}

}  // namespace solver::study
