// STAFF ONLY. Block-banded factorisations in either precision, with two ways to invert a block on the diagonal, to see where they fail: the
// engine's choice is double precision and L D L^T.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <limits>
#include <vector>

#include "solver/block_band.h"

namespace hair_bench {

enum class Inverse { ldlt, cofactors };

// A^-1 b by T's arithmetic. NaN if a block on the diagonal is not positive definite.
template <typename T>
Eigen::VectorXd solve_blocks(const solver::BlockBand& band, const Eigen::VectorXd& b, Inverse inverse) {
  using Block = Eigen::Matrix<T, 3, 3>;
  using Numbers = Eigen::Matrix<T, 3, 1>;
  const int n = band.rows();
  std::vector<std::array<Block, 3>> column(n);  // blocks (j, j), (j + 1, j), (j + 2, j)
  std::vector<Numbers> x(n);
  for (int j = 0; j < n; ++j) {
    x[j] = b.segment<3>(3 * j).cast<T>();
    for (int below = 0; below < 3; ++below) {
      column[j][below].setZero();
      if (j + below < n) column[j][below] = band.block(j + below, below).template cast<T>();
    }
    const Block lower = column[j][0].template triangularView<Eigen::StrictlyLower>();
    column[j][0] = Block(column[j][0].template triangularView<Eigen::Lower>()) + lower.transpose();
  }
  for (int j = 0; j < n; ++j) {
    const auto& [pivot, near, far] = column[j];
    const Eigen::LDLT<Block> ldlt(pivot);
    if (!ldlt.isPositive() || !(ldlt.vectorD().minCoeff() > 0))
      return Eigen::VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
    const Block inverted = pivot.inverse();  // Eigen's inverse of 3 x 3 numbers is that of cofactors
    const auto divided = [&](const auto& right) {
      using Right = std::decay_t<decltype(right)>;
      return inverse == Inverse::cofactors ? Right(inverted * right) : Right(ldlt.solve(right));
    };
    const Block to_near = divided(Block(near.transpose())), to_far = divided(Block(far.transpose()));
    const Numbers y = divided(x[j]);
    if (j + 1 < n) {
      column[j + 1][0] -= near * to_near;
      column[j + 1][1] -= far * to_near;
      x[j + 1] -= near * y;
    }
    if (j + 2 < n) {
      column[j + 2][0] -= far * to_far;
      x[j + 2] -= far * y;
    }
    // For the way back: x_j = y - to_near x_{j+1} - to_far x_{j+2}.
    x[j] = y;
    column[j][1] = to_near;
    column[j][2] = to_far;
  }
  Eigen::VectorXd solution(b.size());
  for (int j = n - 1; j >= 0; --j) {
    if (j + 1 < n) x[j] -= column[j][1] * x[j + 1];
    if (j + 2 < n) x[j] -= column[j][2] * x[j + 2];
    solution.segment<3>(3 * j) = x[j].template cast<double>();
  }
  return solution;
}

}  // namespace hair_bench
