// STAFF ONLY. A right P2 with vectors of its own, and a list of J's rows for all functions.
#include "particles/constraint_forces.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace particles;

using Numbers = std::vector<double>;

struct Vec {
  double x = 0, y = 0, z = 0;
};

Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Vec operator*(double s, Vec a) {
  return {s * a.x, s * a.y, s * a.z};
}

double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vec get(const double* numbers, int i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

Vec own(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

// A row of J: the entry at particle i, whose negative is at j unless j is -1, and the row's C and J' v.
struct Row {
  int i, j;
  Vec entry;
  double value, curvature;
};

std::vector<Row> rows_of(const Constraints& constraints, const double* x, const double* v) {
  std::vector<Row> rows;
  for (const Rod& rod : constraints.rods) {
    const Vec d = get(x, rod.i) - get(x, rod.j), w = get(v, rod.i) - get(v, rod.j);
    rows.push_back({rod.i, rod.j, d, (dot(d, d) - rod.length * rod.length) / 2, dot(w, w)});
  }
  for (const Wire& wire : constraints.wires) {
    const Vec d = get(x, wire.i) - own(wire.centre), w = get(v, wire.i), n = own(wire.normal);
    rows.push_back({wire.i, -1, d, (dot(d, d) - wire.radius * wire.radius) / 2, dot(w, w)});
    rows.push_back({wire.i, -1, n, dot(d, n), 0});
  }
  return rows;
}

double times(const Row& row, const double* v) {
  return dot(row.entry, row.j < 0 ? get(v, row.i) : get(v, row.i) - get(v, row.j));
}

void add(Vec a, int i, double* f) {
  f[3 * i] += a.x;
  f[3 * i + 1] += a.y;
  f[3 * i + 2] += a.z;
}

void add_transposed(const Row& row, double factor, double* f) {
  add(factor * row.entry, row.i, f);
  if (row.j >= 0) add(-factor * row.entry, row.j, f);
}

void accelerate(const Particles& particles, Numbers& f) {
  for (int i = 0; i < particles.count(); ++i)
    for (int k = 3 * i; k < 3 * i + 3; ++k) f[k] = particles.is_pinned(i) ? 0 : f[k] / particles.mass[i];
}

class Products : public implicitMatrix {
 public:
  Products(const Constraints& constraints, const Particles& particles, const State& state)
      : constraints_(constraints), particles_(particles), state_(state) {}

  void matVecMult(double x[], double b[]) override {
    const std::vector<Row> rows = rows_of(constraints_, state_.x.data(), state_.v.data());
    Numbers change(3 * static_cast<std::size_t>(particles_.count()));
    for (std::size_t k = 0; k < rows.size(); ++k) add_transposed(rows[k], x[k], change.data());
    accelerate(particles_, change);
    for (std::size_t k = 0; k < rows.size(); ++k) b[k] = times(rows[k], change.data());
  }

 private:
  const Constraints& constraints_;
  const Particles& particles_;
  const State& state_;
};

}  // namespace

namespace particles {

void constraint_values(const Constraints& constraints, Input x, Output C) {
  int k = 0;
  for (const Row& row : rows_of(constraints, x.data(), x.data())) C[k++] = row.value;
}

void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates) {
  int k = 0;
  for (const Row& row : rows_of(constraints, x.data(), v.data())) rates[k++] = times(row, v.data());
}

void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f) {
  int k = 0;
  for (const Row& row : rows_of(constraints, x.data(), x.data())) add_transposed(row, lambda[k++], f.data());
}

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state) {
  return std::make_unique<Products>(constraints, particles, state);
}

ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda) {
  Numbers a(f.data(), f.data() + f.size()), rhs;
  accelerate(particles, a);
  double squared = 0;
  for (const Row& row : rows_of(constraints, state.x.data(), state.v.data())) {
    rhs.push_back(-row.curvature - times(row, a.data()) - constraints.stiffness * row.value -
                  constraints.damping * times(row, state.v.data()));
    squared += rhs.back() * rhs.back();
  }
  Products matrix(constraints, particles, state);
  int steps = std::max(100, 20 * constraints.rows());
  const double rr = ConjGrad(constraints.rows(), &matrix, lambda.data(), rhs.data(), 1e-20 * squared, &steps);
  return {steps, std::sqrt(rr)};
}

}  // namespace particles
