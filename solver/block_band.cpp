#include "solver/block_band.h"

#include <algorithm>
#include <cmath>

namespace solver {

double BlockBand::norm() const {
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
