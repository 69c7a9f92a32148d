// A band from products: the columns of a matrix whose entries are known to be 0 beyond a reach. Particles that are more
// than twice the reach apart never meet in a row, so that one product gives the columns of all of them: 3 (2 reach + 1)
// products make the matrix. Source: A. R. Curtis, M. J. D. Powell and J. K. Reid, "On the Estimation of Sparse Jacobian
// Matrices", J. Inst. Maths Applics 13 (1974).
#pragma once

#include <algorithm>

#include "particles/force.h"
#include "solver/block_band.h"

namespace particles {

// band += factor * A, the lower half, where product(dx, df) does df += A dx and A is 0 beyond `reach` particles, 0 <=
// reach <= 2. `work`: kBandScratch columns of 3n numbers.
template <typename Product>
void add_products(int reach, double factor, Product product, solver::BlockBand& band, Scratch work) {
  const int n = band.rows(), stride = 2 * reach + 1;
  auto dx = work.col(0), df = work.col(1);
  dx.setZero();
  for (int first = 0; first < std::min(stride, n); ++first)
    for (int axis = 0; axis < 3; ++axis) {
      for (int j = first; j < n; j += stride) dx[3 * j + axis] = 1;
      df.setZero();
      product(dx, df);
      for (int j = first; j < n; j += stride) {
        dx[3 * j + axis] = 0;
        for (int i = j; i <= std::min(j + reach, n - 1); ++i)
          band.block(i, i - j).col(axis) += factor * df.template segment<3>(3 * i);
      }
    }
}

}  // namespace particles
