#include "hair/lab/validate/planar_statics.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/dense_algebra.h"

namespace hair {

namespace {

constexpr int kMostIterations = 200;
constexpr double kMostChange = 1, kLeastChange = 1e-12;

// The index of unknown j of 2(n - 1) among the 3n numbers.
Eigen::Index place(Eigen::Index unknown) {
  return 3 * (unknown / 2 + 1) + (unknown % 2 == 0 ? 0 : 2);
}

// Adds up the two numbers of each segment over the particles below it.
void add_up_below(Eigen::Ref<Eigen::MatrixXd> rows) {
  for (Eigen::Index i = rows.rows() - 3; i >= 0; --i) rows.row(i) += rows.row(i + 2);
}

// Segment j as a direction and a length, and the force at its end, including all forces below.
struct Segment {
  Eigen::Vector2d u;
  double length;

  Segment(const Eigen::VectorXd& x, Eigen::Index j)
      : u(x[3 * j + 3] - x[3 * j], x[3 * j + 5] - x[3 * j + 2]) {
    length = u.norm();
    u /= length;
  }

  Eigen::Vector2d across() const { return {-u[1], u[0]}; }
  Eigen::Matrix2d frame() const {
    Eigen::Matrix2d columns;
    columns << across(), u;
    return columns;
  }
};

// Newton's step: the motion of each segment's end across and along the segment, as it turns and gets longer.
// With K_e the stiffness against changes of segments and F the force at a segment's end, both sums over
// particles,
//
//   (K_e, in the segments' frames, + (u . F, -across . F; -across . F, 0) / length) step = F in its frame:
//
// the second term accounts for the curved path of a turning end.
Eigen::VectorXd newton_step(const particles::Force& force, const Eigen::VectorXd& x,
                            const Eigen::VectorXd& f) {
  Eigen::MatrixXd K = planar_stiffness(force, x);
  add_up_below(K);
  K.transposeInPlace();
  add_up_below(K);
  Eigen::MatrixXd F = f;
  add_up_below(F);
  std::vector<Eigen::Matrix2d> frames;
  for (Eigen::Index j = 0; 2 * j < f.size(); ++j) {
    const Segment segment(x, j);
    frames.push_back(segment.frame());
    F.middleRows<2>(2 * j) = segment.frame().transpose() * F.middleRows<2>(2 * j);
  }
  for (std::size_t j = 0; j < frames.size(); ++j)
    for (std::size_t k = 0; k < frames.size(); ++k)
      K.block<2, 2>(2 * j, 2 * k) = frames[j].transpose() * K.block<2, 2>(2 * j, 2 * k) * frames[k];
  for (Eigen::Index j = 0; 2 * j < f.size(); ++j) {
    const double length = Segment(x, j).length;
    K(2 * j, 2 * j) += F(2 * j + 1, 0) / length;
    K(2 * j, 2 * j + 1) -= F(2 * j, 0) / length;
    K(2 * j + 1, 2 * j) -= F(2 * j, 0) / length;
  }
  return solver::dense_solve(K, F.col(0));
}

// The largest angle that the step turns a segment by, or part of its length that it adds.
double largest_change(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  double largest = 0;
  for (Eigen::Index j = 0; 2 * j < step.size(); ++j)
    largest = std::max(largest, step.segment<2>(2 * j).norm() / Segment(x, j).length);
  return largest;
}

Eigen::VectorXd take(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  Eigen::VectorXd result = x;
  for (Eigen::Index j = 0; 2 * j < step.size(); ++j) {
    const Segment segment(x, j);
    const double angle = step[2 * j] / segment.length, length = segment.length + step[2 * j + 1];
    const Eigen::Vector2d e = length * (std::cos(angle) * segment.u + std::sin(angle) * segment.across());
    result[3 * j + 3] = result[3 * j] + e[0];
    result[3 * j + 5] = result[3 * j + 2] + e[1];
  }
  return result;
}

Eigen::VectorXd forces(const particles::Force& force, const Eigen::VectorXd& x) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(x.size()), result(2 * (x.size() / 3 - 1));
  force.add_force(x, Eigen::VectorXd::Zero(x.size()), all);
  for (Eigen::Index j = 0; j < result.size(); ++j) result[j] = all[place(j)];
  return result;
}

}  // namespace

Eigen::MatrixXd planar_stiffness(const particles::Force& force, particles::Input x) {
  const Eigen::Index size = 2 * (x.size() / 3 - 1);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(x.size());
  Eigen::MatrixXd K(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    Eigen::VectorXd dx = v, df = v;
    dx[place(j)] = 1;
    force.add_dfdx(x, v, dx, df);
    for (Eigen::Index i = 0; i < size; ++i) K(i, j) = -df[place(i)];
  }
  return K;
}

Eigen::Vector2d tip_in_balance(const Strand& strand, const particles::Force& force, Eigen::VectorXd x) {
  // A coordinate is accurate to 2^-53 of the strand's length, and so a segment's force to EA / l0 of that.
  const double length = strand.rest_length.sum(), segment = strand.rest_length.minCoeff();
  const double rounding = 16 * 0x1p-53 * strand.stretch_rigidity * length / segment;
  double change = 1;  // the largest one in the last iteration: radians, or parts of a segment
  for (int iteration = 0;; ++iteration) {
    const Eigen::VectorXd f = forces(force, x);
    if (!(change > kLeastChange) || iteration == kMostIterations) {
      if (f.cwiseAbs().maxCoeff() <= rounding && change <= 1e-9) return {x[x.size() - 3], -x[x.size() - 1]};
      return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    const Eigen::VectorXd step = newton_step(force, x, f);
    change = largest_change(x, step);
    x = take(x, std::min(1.0, kMostChange / change) * step);
  }
}

}  // namespace hair
