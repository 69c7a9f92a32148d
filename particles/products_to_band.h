// Calculates a band matrix from products, if all entries beyond a reach are known to be 0. Particles that are
// more than twice the reach apart share no row, so one product gives the columns of all of them: 3 (2 reach +
// 1) products make the matrix. Source: A. R. Curtis, M. J. D. Powell and J. K. Reid, "On the Estimation of
// Sparse Jacobian Matrices", J. Inst. Maths Applics 13 (1974).
#pragma once

#include <algorithm>
#include <cmath>

#include "particles/force.h"
#include "solver/block_band.h"

namespace particles {

namespace products_to_band {

// Weights without a pattern, so that weighted entries do not cancel by chance. Each particle has three
// numbers, and 16 is not a multiple of 3, so the weights of 16 neighbouring particles differ.
inline double weight(int k) {
  static constexpr double kWeights[16] = {1.31, 1.79, 1.07, 1.93, 1.46, 1.22, 1.64, 1.87,
                                          1.13, 1.58, 1.02, 1.71, 1.39, 1.97, 1.26, 1.51};
  return kWeights[k % 16];
}

// r'L r - r'U r for a matrix A = L + D + U, with r the weights: 0 if A is symmetric.
class SymmetryCheck {
 public:
  // Adds a column's entries from row `first` to row `end` - 1. All other entries are 0.
  void add(Input column, int diagonal, int first, int end) {
    double skew = 0;
    for (int row = first; row < diagonal; ++row) skew -= weight(row) * column[row];
    for (int row = diagonal + 1; row < end; ++row) skew += weight(row) * column[row];
    skew_ += weight(diagonal) * skew;
    size_ += std::abs(column[diagonal]);
  }
  // A definite matrix has its largest entry on its diagonal. The rounding errors of correct formulas are a
  // few times 2^-53 of their entries; an asymmetry below 2^-30 does no harm.
  bool is_symmetric() const { return std::abs(skew_) <= 0x1p-30 * size_; }

 private:
  double skew_ = 0, size_ = 0;
};

}  // namespace products_to_band

// band += factor * A, the lower half, where product(dx, df) does df += A dx and A is 0 beyond `reach`
// particles, 0 <= reach <= 2. Returns false, with useless contents in the band, if A is not symmetric.
// `work`: kBandScratch columns of 3n numbers.
template <typename Product>
[[nodiscard]] bool add_products(int reach, double factor, Product product, solver::BlockBand& band,
                                Scratch work) {
  const int n = band.rows(), stride = 2 * reach + 1;
  auto dx = work.col(0), df = work.col(1);
  products_to_band::SymmetryCheck check;
  dx.setZero();
  for (int first = 0; first < std::min(stride, n); ++first)
    for (int axis = 0; axis < 3; ++axis) {
      for (int j = first; j < n; j += stride) dx[3 * j + axis] = 1;
      df.setZero();
      product(dx, df);
      for (int j = first; j < n; j += stride) {
        dx[3 * j + axis] = 0;
        check.add(df, 3 * j + axis, 3 * std::max(j - reach, 0), 3 * std::min(j + reach + 1, n));
        for (int i = j; i <= std::min(j + reach, n - 1); ++i)
          band.block(i, i - j).col(axis) += factor * df.template segment<3>(3 * i);
      }
    }
  return check.is_symmetric();
}

}  // namespace particles
