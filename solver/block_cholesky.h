// The Cholesky factorisation A = L L' of a symmetric, positive definite matrix with a narrow band of blocks. L has
// the same band, so that it replaces A in its memory. A factorisation and the two solves cost O(n). Source:
// G. H. Golub and C. F. Van Loan, "Matrix Computations" (4th edition, 2013), sections 4.2.5 and 4.3.5.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/block_band.h"

namespace solver {

// Replaces A by L. The numbers on L's diagonal are stored as their reciprocals, since solves divide by them. False
// as soon as a pivot is not a number > 0: A is not positive definite, or not finite. `band` is then of no use.
bool cholesky(BlockBand& band);

// x := L^-1 x and x := L^-T x, 3n numbers, with an L of `cholesky`. L^-T L^-1 b solves A x = b; the rounding errors are
// those of some A + E, |E| <= 10 u |L| |L'| entry by entry, u = 2^-53 (Golub and Van Loan, section 4.2.6: no row of L
// has more than nine numbers).
void solve_lower(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x);
void solve_lower_transposed(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x);

namespace block_cholesky {

using Eigen::Matrix3d, Eigen::Vector3d;

// In these blocks the diagonal holds reciprocals.

inline Vector3d divide(const Matrix3d& L, const Vector3d& b) {
  const double x = b[0] * L(0, 0);
  const double y = (b[1] - L(1, 0) * x) * L(1, 1);
  return {x, y, (b[2] - L(2, 0) * x - L(2, 1) * y) * L(2, 2)};
}

inline Vector3d divide_transposed(const Matrix3d& L, const Vector3d& b) {
  const double z = b[2] * L(2, 2);
  const double y = (b[1] - L(2, 1) * z) * L(1, 1);
  return {(b[0] - L(1, 0) * y - L(2, 0) * z) * L(0, 0), y, z};
}

// A L^-T.
inline Matrix3d divide_right(const Matrix3d& A, const Matrix3d& L) {
  Matrix3d quotient;
  quotient.col(0) = A.col(0) * L(0, 0);
  quotient.col(1) = (A.col(1) - quotient.col(0) * L(1, 0)) * L(1, 1);
  quotient.col(2) = (A.col(2) - quotient.col(0) * L(2, 0) - quotient.col(1) * L(2, 1)) * L(2, 2);
  return quotient;
}

// The factor of a block on the diagonal.
inline bool factor(Matrix3d& A) {
  for (int j = 0; j < 3; ++j) {
    double pivot = A(j, j);
    for (int k = 0; k < j; ++k) pivot -= A(j, k) * A(j, k);
    if (!(pivot > 0) || !std::isfinite(pivot)) return false;
    A(j, j) = 1 / std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i) {
      for (int k = 0; k < j; ++k) A(i, j) -= A(i, k) * A(j, k);
      A(i, j) *= A(j, j);
    }
  }
  return true;
}

}  // namespace block_cholesky

inline bool cholesky(BlockBand& band) {
  using namespace block_cholesky;
  for (int i = 0; i < band.rows(); ++i) {
    Matrix3d diagonal = band.block(i, 0);
    Matrix3d beside[BlockBand::kReach + 1];  // of this row, by `back`
    for (int back = std::min(BlockBand::kReach, i); back > 0; --back) {
      Matrix3d block = band.block(i, back);
      for (int further = back + 1; further <= std::min(BlockBand::kReach, i); ++further)
        block.noalias() -= beside[further].lazyProduct(band.block(i - back, further - back).transpose());
      beside[back] = divide_right(block, band.block(i - back, 0));
      band.block(i, back) = beside[back];
      diagonal.noalias() -= beside[back].lazyProduct(beside[back].transpose());
    }
    if (!factor(diagonal)) return false;
    band.block(i, 0) = diagonal;
  }
  return true;
}

inline void solve_lower(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x) {
  using namespace block_cholesky;
  for (int i = 0; i < L.rows(); ++i) {
    Vector3d left = x.segment<3>(3 * i);
    for (int back = 1; back <= std::min(BlockBand::kReach, i); ++back)
      left.noalias() -= L.block(i, back) * x.segment<3>(3 * (i - back));
    x.segment<3>(3 * i) = divide(L.block(i, 0), left);
  }
}

inline void solve_lower_transposed(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x) {
  using namespace block_cholesky;
  for (int i = L.rows() - 1; i >= 0; --i) {
    const Vector3d solved = divide_transposed(L.block(i, 0), x.segment<3>(3 * i));
    x.segment<3>(3 * i) = solved;
    for (int back = 1; back <= std::min(BlockBand::kReach, i); ++back)
      x.segment<3>(3 * (i - back)).noalias() -= L.block(i, back).transpose() * solved;
  }
}

}  // namespace solver
