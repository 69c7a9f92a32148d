// A symmetric matrix of n x n blocks of 3 x 3 numbers with a narrow band: block (i, j) is 0 for |i - j| > 2.
// The matrices of a strand's implicit steps are such: a force on a particle depends on its neighbours and on
// theirs.
#pragma once

#include <Eigen/Core>

namespace solver {

// The lower half, as a view of the caller's memory: 27 numbers for each row of blocks.
class BlockBand {
 public:
  static constexpr int kReach = 2;                   // the most |i - j| of a block that is not 0
  static constexpr int kColumns = 3 * (kReach + 1);  // of 3n numbers

  // `memory` has 3n rows and kColumns columns, and outlives this view. Nothing is written.
  explicit BlockBand(Eigen::Ref<Eigen::MatrixXd> memory) : memory_(memory) {}

  int rows() const { return static_cast<int>(memory_.rows() / 3); }  // n, in blocks

  // Block (i, i - back), 0 <= back <= min(kReach, i). Of the blocks on the diagonal, back = 0, the lower half
  // counts.
  auto block(int i, int back) { return memory_.block<3, 3>(3 * i, 3 * back); }
  auto block(int i, int back) const { return memory_.block<3, 3>(3 * i, 3 * back); }

  void set_zero() { memory_.setZero(); }

  // The largest sum of |a_ij| in a row: at least the matrix' 2-norm, and so is it of the matrix of all
  // |a_ij|.
  double norm() const;

 private:
  Eigen::Ref<Eigen::MatrixXd> memory_;
};

}  // namespace solver
