// A symmetric matrix of n x n blocks of 3 x 3 numbers with a narrow band: block (i, j) is 0 for |i - j| > 2. The
// matrices of a strand's implicit steps are such: a force on a particle depends on its neighbours and on theirs.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace solver {

// The lower half, as a view of the caller's memory: 27 numbers for each row of blocks.
class BlockBand {
 public:
  static constexpr int kReach = 2;                   // the most |i - j| of a block that is not 0
  static constexpr int kColumns = 3 * (kReach + 1);  // of 3n numbers

  // `memory` has 3n rows and kColumns columns, and outlives this view. Nothing is written.
  explicit BlockBand(Eigen::Ref<Eigen::MatrixXd> memory) : memory_(memory) {}

  int rows() const { return static_cast<int>(memory_.rows() / 3); }  // n, in blocks

  // Block (i, i - back), 0 <= back <= min(kReach, i). Of the blocks on the diagonal, back = 0, the lower half counts.
  auto block(int i, int back) { return memory_.block<3, 3>(3 * i, 3 * back); }
  auto block(int i, int back) const { return memory_.block<3, 3>(3 * i, 3 * back); }

  void set_zero() { memory_.setZero(); }

  // The largest sum of |a_ij| in a row: at least the matrix' 2-norm, and so is it of the matrix of all |a_ij|.
  double norm() const;

 private:
  Eigen::Ref<Eigen::MatrixXd> memory_;
};

inline double BlockBand::norm() const {
  double largest = 0;
  for (int i = 0; i < rows(); ++i)
    for (int row = 0; row < 3; ++row) {
      double sum = 0;
      for (int column = 0; column < 3; ++column)
        sum += std::abs(row >= column ? block(i, 0)(row, column) : block(i, 0)(column, row));
      for (int back = 1; back <= std::min(kReach, i); ++back) sum += block(i, back).row(row).cwiseAbs().sum();
      for (int below = 1; below <= std::min(kReach, rows() - 1 - i); ++below)
        sum += block(i + below, below).col(row).cwiseAbs().sum();
      largest = std::max(largest, sum);
    }
  return largest;
}

}  // namespace solver
