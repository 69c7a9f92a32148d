// STAFF ONLY. A right P2, one row of J after the other. The patches for P2 apply to it.
#include "particles/constraint_forces.h"

#include <cmath>

namespace particles {

void constraint_values(const Constraints& constraints, Input x, Output C) {
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d d = x.segment<3>(3 * rod.i) - x.segment<3>(3 * rod.j);
    C[row] = 0.5 * (d.dot(d) - rod.length * rod.length);
    row += 1;
  }
  for (const Wire& wire : constraints.wires) {
    const Vector3d d = x.segment<3>(3 * wire.i) - wire.centre;
    C[row] = 0.5 * (d.dot(d) - wire.radius * wire.radius);
    C[row + 1] = d.dot(wire.normal);
    row += 2;
  }
}

void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates) {
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d d = x.segment<3>(3 * rod.i) - x.segment<3>(3 * rod.j);
    const Vector3d w = v.segment<3>(3 * rod.i) - v.segment<3>(3 * rod.j);
    rates[row] = d.dot(w);
    row += 1;
  }
  for (const Wire& wire : constraints.wires) {
    const Vector3d d = x.segment<3>(3 * wire.i) - wire.centre;
    const Vector3d w = v.segment<3>(3 * wire.i);
    rates[row] = d.dot(w);
    rates[row + 1] = wire.normal.dot(w);
    row += 2;
  }
}

void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f) {
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d d = x.segment<3>(3 * rod.i) - x.segment<3>(3 * rod.j);
    f.segment<3>(3 * rod.i) += lambda[row] * d;
    f.segment<3>(3 * rod.j) -= lambda[row] * d;
    row += 1;
  }
  for (const Wire& wire : constraints.wires) {
    const Vector3d d = x.segment<3>(3 * wire.i) - wire.centre;
    f.segment<3>(3 * wire.i) += lambda[row] * d + lambda[row + 1] * wire.normal;
    row += 2;
  }
}

namespace {

// Replaces f by W f.
void accelerate(const Particles& particles, Eigen::VectorXd& f) {
  for (int i = 0; i < particles.count(); ++i) {
    if (particles.is_pinned(i))
      f.segment<3>(3 * i).setZero();
    else
      f.segment<3>(3 * i) /= particles.mass[i];
  }
}

class JWJt : public implicitMatrix {
 public:
  JWJt(const Constraints& constraints, const Particles& particles, const State& state)
      : constraints_(constraints), particles_(particles), state_(state) {}

  void matVecMult(double x[], double b[]) override {
    const int m = constraints_.rows();
    Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * particles_.count());
    add_constraint_forces(constraints_, state_.x, Eigen::Map<Eigen::VectorXd>(x, m), f);
    accelerate(particles_, f);
    constraint_rates(constraints_, state_.x, f, Eigen::Map<Eigen::VectorXd>(b, m));
  }

 private:
  const Constraints& constraints_;
  const Particles& particles_;
  const State& state_;
};

}  // namespace

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state) {
  return std::make_unique<JWJt>(constraints, particles, state);
}

ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda) {
  const int m = constraints.rows();
  Eigen::VectorXd rhs(m);
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d w = state.v.segment<3>(3 * rod.i) - state.v.segment<3>(3 * rod.j);
    rhs[row] = -w.dot(w);
    row += 1;
  }
  for (const Wire& wire : constraints.wires) {
    const Vector3d w = state.v.segment<3>(3 * wire.i);
    rhs[row] = -w.dot(w);
    rhs[row + 1] = 0;
    row += 2;
  }
  Eigen::VectorXd a = f, Ja(m), C(m), Jv(m);
  accelerate(particles, a);
  constraint_rates(constraints, state.x, a, Ja);
  constraint_values(constraints, state.x, C);
  constraint_rates(constraints, state.x, state.v, Jv);
  rhs -= Ja + constraints.stiffness * C + constraints.damping * Jv;

  JWJt matrix(constraints, particles, state);
  int steps = 20 * m > 100 ? 20 * m : 100;
  const double tolerance = 1e-10 * rhs.norm();
  const double rr = ConjGrad(m, &matrix, lambda.data(), rhs.data(), tolerance * tolerance, &steps);
  return {steps, std::sqrt(rr)};
}

}  // namespace particles
