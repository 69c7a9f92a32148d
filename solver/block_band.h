// A symmetric matrix of n x n blocks of 3 x 3 numbers with a narrow band: block (i, j) is 0 for |i - j| > 2.
// The matrices of a strand's implicit steps have this form: the force on a particle depends on its neighbours
// and on their neighbours.
#pragma once

#include <Eigen/Core>

namespace solver {

// The lower half, as a view of the caller's memory: 27 numbers for each row of blocks.
class BlockBand {
 public:
  static constexpr int kReach = 2;                   // the largest |i - j| of a block that is not 0
  static constexpr int kColumns = 3 * (kReach + 1);  // each column holds 3n numbers

  // `memory` has 3n rows and kColumns columns, and outlives this view. The constructor writes nothing.
  explicit BlockBand(Eigen::Ref<Eigen::MatrixXd> memory) : memory_(memory) {}

  int rows() const { return static_cast<int>(memory_.rows() / 3); }  // n, in blocks

  // Block (i, i - back), 0 <= back <= min(kReach, i). For a block on the diagonal (back = 0) only the lower
  // half is used.
  auto block(int i, int back) { return memory_.block<3, 3>(3 * i, 3 * back); }
  auto block(int i, int back) const { return memory_.block<3, 3>(3 * i, 3 * back); }

  void set_zero() { memory_.setZero(); }

  // The largest sum of |a_ij| in a row. It is a bound for the 2-norm of the matrix, and of the matrix of all
  // |a_ij|.
  double norm() const;

 private:
  Eigen::Ref<Eigen::MatrixXd> memory_;
};

}  // namespace solver
