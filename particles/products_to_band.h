// Calculates a band matrix from products, for a force that depends on the segments between neighbouring
// particles. In the segments e_i = x_i - x_{i-1} such a matrix is a narrower band T, A = E'T E. If T couples
// no segments, one product gives a column for each of them: 3 products. If it couples neighbours, it is
// symmetric and needs two sets of segments: 6 products. Row 1 of the second set's product shows the block
// between segments 1 and 2; each next row shows the sum of two blocks, one of which is known by then. Source:
// M. J. D. Powell and Ph. L. Toint, "On the Estimation of Sparse Hessian Matrices", SIAM J. Numer. Anal. 16
// (1979).
#pragma once

#include "particles/force.h"
#include "solver/block_band.h"

namespace particles {

// band += factor * A, the lower half, where product(dx, df) does df += A dx, and A couples segments that are
// less than `reach` apart, reach 1 or 2. One more product, of weights without a pattern, tests the matrix.
// Returns false, with useless contents in the band, if A is not symmetric or has other entries. `work`:
// kBandScratch columns of 3n numbers.
template <typename Product>
[[nodiscard]] bool add_products(int reach, double factor, Product product, solver::BlockBand& band,
                                Scratch work) {
  const int n = band.rows();
  auto dx = work.col(0), df = work.col(1);
  // Segment i, between the particles i - 1 and i: its own block, and the one between it and i + 1.
  const auto own = [&](int i) { return work.block<3, 3>(3 * i, 2); };
  const auto beside = [&](int i) { return work.block<3, 3>(3 * i, 5); };
  // df := T e for the segments of dx: all particles from i on pull segment i.
  const auto pulls = [&] {
    df.setZero();
    product(dx, df);
    for (int i = n - 2; i >= 0; --i) df.template segment<3>(3 * i) += df.template segment<3>(3 * i + 3);
  };

  for (int set = 0; set < reach; ++set)
    for (int axis = 0; axis < 3; ++axis) {
      dx.setZero();
      for (int i = 1; i < n; ++i) dx[3 * i + axis] = dx[3 * i - 3 + axis] + (i % reach == set);
      pulls();
      for (int i = 1; i < n; ++i)
        (i % reach == set ? own(i) : beside(i)).col(axis) = df.template segment<3>(3 * i);
    }
  for (int i = 2; reach > 1 && i < n; ++i) beside(i) -= beside(i - 1).transpose().eval();

  static constexpr double kWeights[16] = {1.31, 1.79, 1.07, 1.93, 1.46, 1.22, 1.64, 1.87,
                                          1.13, 1.58, 1.02, 1.71, 1.39, 1.97, 1.26, 1.51};
  const auto weights = [](int i) { return Eigen::Map<const Vector3d>(kWeights + (5 * i) % 14); };
  dx.template head<3>() = weights(0);
  for (int i = 1; i < n; ++i) dx.template segment<3>(3 * i) = dx.template segment<3>(3 * i - 3) + weights(i);
  pulls();
  double off = df.template head<3>().template lpNorm<1>(), size = 0;  // nothing pulls the whole strand
  for (int i = 1; i < n; ++i) {
    Vector3d expected = own(i) * weights(i);
    if (reach > 1 && i + 1 < n) expected += beside(i) * weights(i + 1);
    if (reach > 1 && i > 1) expected += beside(i - 1).transpose() * weights(i - 1);
    off += (df.template segment<3>(3 * i) - expected).template lpNorm<1>();
    size += own(i).template lpNorm<1>();
  }

  for (int i = 1; i < n; ++i) {
    const Eigen::Matrix3d block = factor * own(i);
    band.block(i - 1, 0) += block;
    band.block(i, 0) += block;
    band.block(i, 1) -= block;
    if (reach == 1 || i + 1 == n) continue;
    const Eigen::Matrix3d below = factor * beside(i).transpose();
    band.block(i, 0) -= below + below.transpose();
    band.block(i, 1) += below;
    band.block(i + 1, 1) += below;
    band.block(i + 1, 2) -= below;
  }
  // The rounding errors of correct formulas are a few times 2^-53 of their entries; errors below 2^-30 do no
  // harm.
  return off <= 0x1p-30 * size;
}

}  // namespace particles
