#include "hair/validate/planar_statics.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hair {

namespace {

constexpr int kMostIterations = 200;
constexpr double kMostChange = 0.5, kLeastChange = 1e-12;

// Unknown j of 2(n - 1), among the 3n numbers.
Eigen::Index place(Eigen::Index unknown) {
  return 3 * (unknown / 2 + 1) + (unknown % 2 == 0 ? 0 : 2);
}

Eigen::VectorXd planar(const Eigen::VectorXd& all) {
  Eigen::VectorXd result(2 * (all.size() / 3 - 1));
  for (Eigen::Index j = 0; j < result.size(); ++j) result[j] = all[place(j)];
  return result;
}

Eigen::VectorXd force_at(const particles::Force& force, const Eigen::VectorXd& x) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(x.size());
  force.add_force(x, Eigen::VectorXd::Zero(x.size()), f);
  return f;
}

// Where x + dx goes if segments turn on the way.
Eigen::VectorXd turned(const Eigen::VectorXd& x, const Eigen::VectorXd& dx) {
  Eigen::VectorXd result = x;
  for (Eigen::Index i = 0; i + 3 < x.size(); i += 3) {
    const Eigen::Vector2d e(x[i + 3] - x[i], x[i + 5] - x[i + 2]);
    const Eigen::Vector2d de(dx[i + 3] - dx[i], dx[i + 5] - dx[i + 2]);
    const double length = e.norm();
    const Eigen::Vector2d u = e / length, across(-u[1], u[0]);
    const double angle = across.dot(de) / length, longer = length + u.dot(de);
    const Eigen::Vector2d moved = longer * (std::cos(angle) * u + std::sin(angle) * across);
    result[i + 3] = result[i] + moved[0];
    result[i + 5] = result[i + 2] + moved[1];
  }
  return result;
}

// The largest angle, and the largest part of its length, that dx changes a segment by.
double largest_change(const Eigen::VectorXd& x, const Eigen::VectorXd& dx) {
  double largest = 0;
  for (Eigen::Index i = 0; i + 3 < x.size(); i += 3)
    largest = std::max(largest, (dx.segment<3>(i + 3) - dx.segment<3>(i)).norm() /
                                    (x.segment<3>(i + 3) - x.segment<3>(i)).norm());
  return largest;
}

}  // namespace

Eigen::MatrixXd planar_stiffness(const particles::Force& force, particles::Input x) {
  const Eigen::Index size = 2 * (x.size() / 3 - 1);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(x.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  constexpr Eigen::Index kGroups = 10;
  Eigen::VectorXd dx(x.size()), df(x.size());
  for (Eigen::Index group = 0; group < std::min(kGroups, size); ++group) {
    dx.setZero();
    df.setZero();
    for (Eigen::Index j = group; j < size; j += kGroups) dx[place(j)] = 1;
    force.add_dfdx(x, v, dx, df);
    for (Eigen::Index j = group; j < size; j += kGroups)
      for (Eigen::Index i = std::max<Eigen::Index>(0, j / 2 * 2 - 4);
           i < std::min<Eigen::Index>(size, j / 2 * 2 + 6); ++i)
        K(i, j) = -df[place(i)];
  }
  return K;
}

Eigen::Vector2d planar_tip(particles::Input x) {
  return {x[x.size() - 3], -x[x.size() - 1]};
}

Balance planar_balance(const Strand& strand, const particles::Force& force, Eigen::VectorXd x) {
  Balance balance;
  balance.x = std::move(x);
  // A coordinate is known to 2^-53 of the strand's length, and so a segment's force to EA / l0 of that.
  const double length = strand.rest_length.sum(), segment = strand.rest_length.minCoeff();
  balance.rounding = 16 * 0x1p-53 * strand.stretch_rigidity * length / segment;
  for (;;) {
    const Eigen::VectorXd f = planar(force_at(force, balance.x));
    balance.residual = f.cwiseAbs().maxCoeff();
    if (!(balance.change > kLeastChange) || balance.iterations == kMostIterations) return balance;
    const Eigen::LDLT<Eigen::MatrixXd> factors(planar_stiffness(force, balance.x));
    const Eigen::VectorXd step = factors.solve(f);
    Eigen::VectorXd dx = Eigen::VectorXd::Zero(balance.x.size());
    for (Eigen::Index j = 0; j < step.size(); ++j) dx[place(j)] = step[j];
    balance.change = largest_change(balance.x, dx);
    dx *= std::min(1.0, kMostChange / balance.change);
    balance.x = turned(balance.x, dx);
    ++balance.iterations;
  }
}

}  // namespace hair
