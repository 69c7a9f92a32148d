// STAFF ONLY. P2: constraint forces. The contract is in particles/constraint_forces.h.

#include "particles/constraint_forces.h"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

Vector3d at(Input vector, int i) {
  return vector.segment<3>(3 * i);
}

Vector3d between(Input vector, const Rod& rod) {
  return at(vector, rod.i) - at(vector, rod.j);
}

// Replaces forces f by the accelerations W f.
void divide_by_mass(const Particles& particles, Output f) {
  for (int i = 0; i < particles.count(); ++i)
    f.segment<3>(3 * i) *= particles.is_pinned(i) ? 0 : 1 / particles.mass[i];
}

// Adds J' v to sum: the rate of J v while the velocities stay the same.
void add_curvature(const Constraints& constraints, Input v, Output sum) {
  int row = 0;
  for (const Rod& rod : constraints.rods) sum[row++] += between(v, rod).squaredNorm();
  for (const Wire& wire : constraints.wires) {
    sum[row] += at(v, wire.i).squaredNorm();
    row += 2;  // a plane's normal does not change
  }
}

class ConstraintMatrix : public implicitMatrix {
 public:
  ConstraintMatrix(const Constraints& constraints, const Particles& particles, const State& state)
      : constraints_(constraints), particles_(particles), state_(state), change_(state.x.size()) {}

  void matVecMult(double x[], double b[]) override {
    change_.setZero();
    add_constraint_forces(constraints_, state_.x, Eigen::Map<const Eigen::VectorXd>(x, constraints_.rows()),
                          change_);
    divide_by_mass(particles_, change_);
    constraint_rates(constraints_, state_.x, change_, Eigen::Map<Eigen::VectorXd>(b, constraints_.rows()));
  }

 private:
  const Constraints& constraints_;
  const Particles& particles_;
  const State& state_;
  Eigen::VectorXd change_;  // the velocities' change W J^T x
};

}  // namespace

void constraint_values(const Constraints& constraints, Input x, Output C) {
  int row = 0;
  for (const Rod& rod : constraints.rods)
    C[row++] = (between(x, rod).squaredNorm() - rod.length * rod.length) / 2;
  for (const Wire& wire : constraints.wires) {
    const Vector3d d = at(x, wire.i) - wire.centre;
    C[row++] = (d.squaredNorm() - wire.radius * wire.radius) / 2;
    C[row++] = wire.normal.dot(d);
  }
}

void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates) {
  int row = 0;
  for (const Rod& rod : constraints.rods) rates[row++] = between(x, rod).dot(between(v, rod));
  for (const Wire& wire : constraints.wires) {
    rates[row++] = (at(x, wire.i) - wire.centre).dot(at(v, wire.i));
    rates[row++] = wire.normal.dot(at(v, wire.i));
  }
}

void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f) {
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d on_i = lambda[row++] * between(x, rod);
    f.segment<3>(3 * rod.i) += on_i;
    f.segment<3>(3 * rod.j) -= on_i;
  }
  for (const Wire& wire : constraints.wires) {
    f.segment<3>(3 * wire.i) += lambda[row++] * (at(x, wire.i) - wire.centre);
    f.segment<3>(3 * wire.i) += lambda[row++] * wire.normal;
  }
}

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state) {
  return std::make_unique<ConstraintMatrix>(constraints, particles, state);
}

ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda) {
  const int rows = constraints.rows();
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(rows), term(rows);
  add_curvature(constraints, state.v, rhs);
  Eigen::VectorXd acceleration = f;
  divide_by_mass(particles, acceleration);
  constraint_rates(constraints, state.x, acceleration, term);
  rhs += term;
  constraint_values(constraints, state.x, term);
  rhs += constraints.stiffness * term;
  constraint_rates(constraints, state.x, state.v, term);
  rhs += constraints.damping * term;
  rhs = -rhs;

  ConstraintMatrix matrix(constraints, particles, state);
  const double norm = rhs.norm();
  const int most = std::max(100, 20 * rows);
  ConstraintReport report{0, 0};
  // The tolerance gets looser if constraints contradict each other a little.
  for (const double relative : {1e-10, 1e-8, 1e-6}) {
    const double tolerance = relative * norm;
    int steps = most;
    report.residual =
        std::sqrt(ConjGrad(rows, &matrix, lambda.data(), rhs.data(), tolerance * tolerance, &steps));
    report.steps += steps;
    if (steps < most || report.residual <= tolerance) break;
  }
  return report;
}

}  // namespace particles
