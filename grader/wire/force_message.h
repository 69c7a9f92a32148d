// STAFF ONLY. The worker's questions about a force that the suite holds: operators of Session::product, each
// with its vectors concatenated into one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solver/block_band.h"

namespace grader::inline wire {

// These are far from the numbers of matrices, which start at 0, because an exercise may use both. A question
// also holds the present sum, so that sums have the same bits wherever the force is.
inline constexpr int kForceEnergy = 100;  // x             -> energy, one number
inline constexpr int kForceForce = 101;   // x, v, f       -> f, 3n
inline constexpr int kForceDfdx = 102;    // x, v, dx, df  -> df + (df/dx) dx, 3n
inline constexpr int kForceDfdv = 103;    // x, v, dv, df  -> df + (df/dv) dv, 3n
// x, v, by_dfdx, by_dfdv -> 1 if there is a band, 0 if there is none; then the band's 27n numbers, column by
// column
inline constexpr int kForceBand = 104;

// Returns the length of an answer about a band.
inline constexpr std::size_t size_of_band(int size) {
  return 1 + 9 * static_cast<std::size_t>(size);
}

// Adds the band of an answer; returns false if there is none.
inline bool add_answered_band(std::vector<double>& answer, solver::BlockBand& band) {
  const solver::BlockBand answered(
      Eigen::Map<Eigen::MatrixXd>(answer.data() + 1, 3 * band.rows(), solver::BlockBand::kColumns));
  for (int i = 0; i < band.rows(); ++i)
    for (int back = 0; back <= std::min(i, solver::BlockBand::kReach); ++back)
      band.block(i, back) += answered.block(i, back);
  return answer[0] != 0;
}

}  // namespace grader::wire
