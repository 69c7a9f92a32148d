// STAFF ONLY. A right P2 that writes J and J' out as tables of all their numbers, row by row, and multiplies
// by them.
#include "particles/constraint_forces.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace particles;

struct Table {
  int rows, cols;
  std::vector<double> entries;

  Table(int r, int c) : rows(r), cols(c), entries(static_cast<std::size_t>(r) * c) {}
  double* row(int i) { return entries.data() + static_cast<std::size_t>(i) * cols; }

  void times(const double* x, double* b) {
    for (int i = 0; i < rows; ++i) {
      const double* entry = row(i);
      b[i] = 0;
      for (int j = 0; j < cols; ++j) b[i] += entry[j] * x[j];
    }
  }
  void add_transposed(const double* x, double* b) {
    for (int i = 0; i < rows; ++i) {
      const double* entry = row(i);
      for (int j = 0; j < cols; ++j) b[j] += entry[j] * x[i];
    }
  }
};

void put(Table& table, int row, int particle, double sign, const Vector3d& value) {
  for (int k = 0; k < 3; ++k) table.row(row)[3 * particle + k] += sign * value[k];
}

// dC/dx, from differences of `at` for rods and radii, and from the planes' normals. With the velocities for
// `at`, and without normals, it is J'.
Table jacobian(const Constraints& constraints, Input at, bool rate) {
  Table J(constraints.rows(), static_cast<int>(at.size()));
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d difference = at.segment<3>(3 * rod.i) - at.segment<3>(3 * rod.j);
    put(J, row, rod.i, 1, difference);
    put(J, row, rod.j, -1, difference);
    ++row;
  }
  for (const Wire& wire : constraints.wires) {
    Vector3d radius = at.segment<3>(3 * wire.i);
    if (!rate) radius -= wire.centre;
    put(J, row, wire.i, 1, radius);
    if (!rate) put(J, row + 1, wire.i, 1, wire.normal);
    row += 2;
  }
  return J;
}

std::vector<double> inverse_masses(const Particles& particles) {
  std::vector<double> W;
  for (int i = 0; i < particles.count(); ++i)
    W.insert(W.end(), 3, particles.is_pinned(i) ? 0 : 1 / particles.mass[i]);
  return W;
}

class JWJt : public implicitMatrix {
 public:
  JWJt(const Constraints& constraints, const Particles& particles, const State& state)
      : constraints_(constraints), particles_(particles), state_(state) {}

  void matVecMult(double x[], double b[]) override {
    Table J = jacobian(constraints_, state_.x, false);
    const std::vector<double> W = inverse_masses(particles_);
    std::vector<double> change(W.size());
    J.add_transposed(x, change.data());
    for (std::size_t k = 0; k < W.size(); ++k) change[k] *= W[k];
    J.times(change.data(), b);
  }

 private:
  const Constraints& constraints_;
  const Particles& particles_;
  const State& state_;
};

}  // namespace

namespace particles {

void constraint_values(const Constraints& constraints, Input x, Output C) {
  Eigen::Index row = 0;
  for (const auto& [i, j, length] : constraints.rods) {
    const Vector3d d = x.segment<3>(3 * i) - x.segment<3>(3 * j);
    C[row++] = 0.5 * d.squaredNorm() - 0.5 * length * length;
  }
  for (const auto& [i, centre, normal, radius] : constraints.wires) {
    const Vector3d d = x.segment<3>(3 * i) - centre;
    C[row] = 0.5 * d.squaredNorm() - 0.5 * radius * radius;
    C[row + 1] = d.dot(normal);
    row += 2;
  }
}

void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates) {
  jacobian(constraints, x, false).times(v.data(), rates.data());
}

void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f) {
  jacobian(constraints, x, false).add_transposed(lambda.data(), f.data());
}

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state) {
  return std::make_unique<JWJt>(constraints, particles, state);
}

// J W J^T lambda = -J'v - J (W f + damping v) - stiffness C
ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda) {
  const int rows = constraints.rows();
  std::vector<double> moved = inverse_masses(particles), along(rows), curving(rows);
  for (std::size_t k = 0; k < moved.size(); ++k)
    moved[k] = moved[k] * f[static_cast<Eigen::Index>(k)] +
               constraints.damping * state.v[static_cast<Eigen::Index>(k)];
  jacobian(constraints, state.x, false).times(moved.data(), along.data());
  jacobian(constraints, state.v, true).times(state.v.data(), curving.data());
  Eigen::VectorXd right(rows);
  constraint_values(constraints, state.x, right);
  for (int i = 0; i < rows; ++i) right[i] = -(curving[i] + along[i] + constraints.stiffness * right[i]);

  JWJt matrix(constraints, particles, state);
  ConstraintReport report;
  report.steps = std::max(100, 20 * rows);
  const double epsilon = std::pow(1e-10 * right.norm(), 2);
  report.residual = std::sqrt(ConjGrad(rows, &matrix, lambda.data(), right.data(), epsilon, &report.steps));
  return report;
}

}  // namespace particles
