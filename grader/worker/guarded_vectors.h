// STAFF ONLY. Vectors and scratch memory for exercises, in front of a protected page.
#pragma once

#include <limits>

#include "grader/worker/session.h"
#include "particles/vectors.h"

namespace grader {

class GuardedVector {
 public:
  explicit GuardedVector(const std::vector<double>& values)
      : buffer_(values), view_(buffer_.data(), static_cast<Eigen::Index>(values.size())) {}

  Eigen::Map<Eigen::VectorXd>& view() { return view_; }
  std::span<const double> values() const { return buffer_.values(); }

 private:
  GuardedBuffer buffer_;
  Eigen::Map<Eigen::VectorXd> view_;
};

// Filled with NaN, so that reading before writing becomes visible.
class GuardedScratch {
 public:
  GuardedScratch(int rows, int columns)
      : buffer_(std::vector<double>(static_cast<std::size_t>(rows) * columns,
                                    std::numeric_limits<double>::quiet_NaN())),
        view_(buffer_.data(), rows, columns) {}

  Eigen::Map<Eigen::MatrixXd>& view() { return view_; }

 private:
  GuardedBuffer buffer_;
  Eigen::Map<Eigen::MatrixXd> view_;
};

}  // namespace grader
