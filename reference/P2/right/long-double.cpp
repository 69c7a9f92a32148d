// STAFF ONLY. A right P2 in long double, constraint by constraint: each knows its gradients, and two functions go through
// them all.
#include "particles/constraint_forces.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace particles;

using Real = long double;
using Long = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Long3 = Eigen::Matrix<Real, 3, 1>;

template <typename Vector>
Long3 at(const Vector& vector, int i) {
  return vector.template segment<3>(3 * i).template cast<Real>();
}

// Calls for_row(C, gradient at i, j or -1, J'v) for each row; at j the gradient is the opposite.
template <typename ForRow>
void each_row(const Constraints& constraints, Input x, Input v, const ForRow& for_row) {
  for (const Rod& rod : constraints.rods) {
    const Long3 d = at(x, rod.i) - at(x, rod.j), w = at(v, rod.i) - at(v, rod.j);
    const Real length = rod.length;
    for_row((d.dot(d) - length * length) / 2, d, rod.i, rod.j, w.dot(w));
  }
  for (const Wire& wire : constraints.wires) {
    const Long3 d = at(x, wire.i) - wire.centre.cast<Real>(), normal = wire.normal.cast<Real>();
    const Real radius = wire.radius;
    for_row((d.dot(d) - radius * radius) / 2, d, wire.i, -1, at(v, wire.i).squaredNorm());
    for_row(normal.dot(d), normal, wire.i, -1, Real{0});
  }
}

// J u
template <typename Vector>
Long rates_of(const Constraints& constraints, Input x, const Vector& u) {
  Long rates(constraints.rows());
  int row = 0;
  each_row(constraints, x, x, [&](Real, const Long3& gradient, int i, int j, Real) {
    const Long3 difference = j < 0 ? at(u, i) : Long3(at(u, i) - at(u, j));
    rates[row++] = gradient.dot(difference);
  });
  return rates;
}

// J^T lambda
Long forces_of(const Constraints& constraints, Input x, Input lambda) {
  Long f = Long::Zero(x.size());
  int row = 0;
  each_row(constraints, x, x, [&](Real, const Long3& gradient, int i, int j, Real) {
    const Long3 force = static_cast<Real>(lambda[row++]) * gradient;
    f.segment<3>(3 * i) += force;
    if (j >= 0) f.segment<3>(3 * j) -= force;
  });
  return f;
}

Long accelerations(const Particles& particles, const Long& f) {
  Long a = Long::Zero(f.size());
  for (int i = 0; i < particles.count(); ++i)
    if (!particles.is_pinned(i)) a.segment<3>(3 * i) = f.segment<3>(3 * i) / Real{particles.mass[i]};
  return a;
}

class Matrix : public implicitMatrix {
 public:
  Matrix(const Constraints& constraints, const Particles& particles, const State& state)
      : constraints_(constraints), particles_(particles), state_(state) {}

  void matVecMult(double x[], double b[]) override {
    const int rows = constraints_.rows();
    const Long f = forces_of(constraints_, state_.x, Eigen::Map<const Eigen::VectorXd>(x, rows));
    Eigen::Map<Eigen::VectorXd>(b, rows) =
        rates_of(constraints_, state_.x, accelerations(particles_, f)).cast<double>();
  }

 private:
  const Constraints& constraints_;
  const Particles& particles_;
  const State& state_;
};

}  // namespace

namespace particles {

void constraint_values(const Constraints& constraints, Input x, Output C) {
  int row = 0;
  each_row(constraints, x, x,
           [&](Real value, const Long3&, int, int, Real) { C[row++] = static_cast<double>(value); });
}

void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates) {
  rates = rates_of(constraints, x, v).cast<double>();
}

void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f) {
  f += forces_of(constraints, x, lambda).cast<double>();
}

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state) {
  return std::make_unique<Matrix>(constraints, particles, state);
}

ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda) {
  Long sum = rates_of(constraints, state.x, accelerations(particles, f.cast<Real>())) +
             Real{constraints.damping} * rates_of(constraints, state.x, state.v);
  int row = 0;
  each_row(constraints, state.x, state.v, [&](Real value, const Long3&, int, int, Real curving) {
    sum[row++] += curving + constraints.stiffness * value;
  });
  Eigen::VectorXd right = (-sum).cast<double>();

  Matrix matrix(constraints, particles, state);
  const double limit = 1e-10 * right.norm();
  int steps = std::max(100, 20 * row);
  const double squared = ConjGrad(row, &matrix, lambda.data(), right.data(), limit * limit, &steps);
  return {steps, std::sqrt(squared)};
}

}  // namespace particles
