// STAFF ONLY. A rope by extended position-based dynamics, as plainly as it is usually written, to time the engine beside. Source:
// M. Macklin, M. Mueller and N. Chentanez, "XPBD: Position-Based Simulation of Compliant Constrained Dynamics" (MIG 2016),
// algorithm 1: constraints |x_{i+1} - x_i| - l0, with the compliance l0 / EA, relaxed one after the other.
#pragma once

#include <vector>

#include "hair/strand.h"

namespace hair_bench {

class PlainXpbd {
 public:
  PlainXpbd(const hair::Strand& strand, const Eigen::VectorXd& start, int iterations)
      : strand_(strand),
        iterations_(iterations),
        x_(start),
        before_(start),
        v_(Eigen::VectorXd::Zero(start.size())),
        lambda_(strand.segments()) {}

  void step(double h) {
    before_ = x_;
    for (int i = 1; i < strand_.count(); ++i) {
      v_[3 * i + 2] -= 9.81 * h;
      x_.segment<3>(3 * i) += h * v_.segment<3>(3 * i);
    }
    lambda_.setZero();
    for (int iteration = 0; iteration < iterations_; ++iteration)
      for (int i = 0; i < strand_.segments(); ++i) {
        const double l0 = strand_.rest_length[i], compliance = l0 / strand_.stretch_rigidity / (h * h);
        const double w0 = i == 0 ? 0 : 1 / strand_.mass[i], w1 = 1 / strand_.mass[i + 1];
        const Eigen::Vector3d e = x_.segment<3>(3 * i + 3) - x_.segment<3>(3 * i);
        const double length = e.norm();
        if (length == 0) continue;
        const double change = (l0 - length - compliance * lambda_[i]) / (w0 + w1 + compliance);
        lambda_[i] += change;
        x_.segment<3>(3 * i) -= w0 * change / length * e;
        x_.segment<3>(3 * i + 3) += w1 * change / length * e;
      }
    v_ = (x_ - before_) / h;
  }

  const Eigen::VectorXd& positions() const { return x_; }

 private:
  const hair::Strand& strand_;
  int iterations_;
  Eigen::VectorXd x_, before_, v_, lambda_;
};

}  // namespace hair_bench
