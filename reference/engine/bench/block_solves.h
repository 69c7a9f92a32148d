// STAFF ONLY. Block-banded factorisations in either precision, with two ways to invert a block on the diagonal, to see where they fail: the
// engine's choice is double precision and L D L^T.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <vector>

#include "solver/block_band.h"

namespace hair_bench {

enum class Inverse { ldlt, cofactors };

// The inverse of a symmetric block, as a product with something of three rows.
template <typename T>
class InvertedBlock {
 public:
  using Block = Eigen::Matrix<T, 3, 3>;

  InvertedBlock(const Block& a, Inverse inverse) : inverse_(inverse) {
    if (inverse == Inverse::cofactors) {
      cofactors_ << a.col(1).cross(a.col(2)), a.col(2).cross(a.col(0)), a.col(0).cross(a.col(1));
      const T determinant = a.col(0).dot(cofactors_.col(0));
      cofactors_ /= determinant;
      definite_ = determinant > 0;
    }
    d_[0] = a(0, 0);
    l_[0] = a(1, 0) / d_[0];
    l_[1] = a(2, 0) / d_[0];
    d_[1] = a(1, 1) - l_[0] * a(1, 0);
    const T c = a(2, 1) - l_[1] * a(1, 0);
    l_[2] = c / d_[1];
    d_[2] = a(2, 2) - l_[1] * a(2, 0) - l_[2] * c;
    if (inverse == Inverse::ldlt) definite_ = d_.minCoeff() > 0;
  }

  bool is_definite() const { return definite_; }

  template <typename Right>
  Right times(Right b) const {
    if (inverse_ == Inverse::cofactors) return cofactors_.lazyProduct(b);
    b.row(1) -= l_[0] * b.row(0);
    b.row(2) -= l_[1] * b.row(0) + l_[2] * b.row(1);
    for (int row = 0; row < 3; ++row) b.row(row) /= d_[row];
    b.row(1) -= l_[2] * b.row(2);
    b.row(0) -= l_[0] * b.row(1) + l_[1] * b.row(2);
    return b;
  }

 private:
  Inverse inverse_;
  Block cofactors_;
  Eigen::Matrix<T, 3, 1> d_, l_;  // l: (1, 0), (2, 0), (2, 1)
  bool definite_ = false;
};

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
    for (int row = 0; row < 3; ++row)
      for (int beside = row + 1; beside < 3; ++beside) column[j][0](row, beside) = column[j][0](beside, row);
  }
  for (int j = 0; j < n; ++j) {
    const auto& [pivot, near, far] = column[j];
    const InvertedBlock<T> inverted(pivot, inverse);
    if (!inverted.is_definite())
      return Eigen::VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
    const Block to_near = inverted.times(Block(near.transpose())),
                to_far = inverted.times(Block(far.transpose()));
    const Numbers y = inverted.times(x[j]);
    if (j + 1 < n) {
      column[j + 1][0] -= near.lazyProduct(to_near);
      column[j + 1][1] -= far.lazyProduct(to_near);
      x[j + 1] -= near.lazyProduct(y);
    }
    if (j + 2 < n) {
      column[j + 2][0] -= far.lazyProduct(to_far);
      x[j + 2] -= far.lazyProduct(y);
    }
    // For the way back: x_j = y - to_near x_{j+1} - to_far x_{j+2}.
    x[j] = y;
    column[j][1] = to_near;
    column[j][2] = to_far;
  }
  Eigen::VectorXd solution(b.size());
  for (int j = n - 1; j >= 0; --j) {
    if (j + 1 < n) x[j] -= column[j][1].lazyProduct(x[j + 1]);
    if (j + 2 < n) x[j] -= column[j][2].lazyProduct(x[j + 2]);
    solution.segment<3>(3 * j) = x[j].template cast<double>();
  }
  return solution;
}

}  // namespace hair_bench
