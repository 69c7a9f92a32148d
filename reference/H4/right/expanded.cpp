// STAFF ONLY. A right H4 that scales vectors before products: df/dv (a x) and df/dx (a b x), both into one sum.
#include "particles/implicit_euler.h"

#include <cmath>

#include "particles/solve_implicit.h"

namespace particles {

using Eigen::Map;
using Eigen::VectorXd;

static void clear_pinned(const Particles& particles, Output vector) {
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) vector.segment<3>(3 * i).setZero();
}

class Matrix : public implicitMatrix {
 public:
  Matrix(const Force& force, const Particles& particles, const State& state, double a, double b)
      : force(force), particles(particles), state(state), a(a), b(b) {
    x_free.resize(state.x.size());
    change.resize(state.x.size());
  }

  void matVecMult(double x[], double result[]) override {
    const int n = particles.count();
    for (int i = 0; i < 3 * n; ++i) x_free[i] = x[i];
    clear_pinned(particles, x_free);

    change.setZero();
    x_free *= a;
    force.add_dfdv(state.x, state.v, x_free, change);
    x_free *= b;
    force.add_dfdx(state.x, state.v, x_free, change);

    for (int i = 0; i < n; ++i) {
      for (int j = 3 * i; j < 3 * i + 3; ++j) {
        if (particles.is_pinned(i))
          result[j] = x[j];
        else
          result[j] = particles.mass[i] * x[j] - change[j];
      }
    }
  }

 private:
  const Force& force;
  const Particles& particles;
  const State& state;
  double a, b;
  VectorXd x_free, change;
};

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<Matrix>(force, particles, state, a, b);
}

void implicit_rhs(const Force& force, const Particles& particles, const State& state, double a, double b,
                  Output rhs) {
  // rhs = a f + K (a b v)
  const VectorXd way = a * b * state.v;
  rhs.setZero();
  force.add_force(state.x, state.v, rhs);
  rhs *= a;
  force.add_dfdx(state.x, state.v, way, rhs);
  clear_pinned(particles, rhs);
}

SolveReport solve_plain(implicitMatrix& matrix, Output rhs, double tolerance, int most_steps, Output dv) {
  SolveReport report;
  report.rhs = rhs.norm();
  report.steps = most_steps;
  const double epsilon = tolerance * tolerance * rhs.squaredNorm();
  const double error =
      ConjGrad(static_cast<int>(rhs.size()), &matrix, dv.data(), rhs.data(), epsilon, &report.steps);
  report.residual = std::sqrt(error);
  report.converged = error <= epsilon;
  return report;
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch) {
  VectorXd dv(state.v.size());
  const SolveReport report = solve_implicit(force, particles, state, h, h, tolerance, dv, scratch);
  state.v += dv;
  state.x += h * state.v;
  return report;
}

}  // namespace particles
