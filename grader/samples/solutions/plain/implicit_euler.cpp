// STAFF ONLY. A right H4, straight from the formulas. The patches for H4 apply to it.
#include "particles/implicit_euler.h"

#include <algorithm>
#include <cmath>

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
    Kx.resize(state.x.size());
    Dx.resize(state.x.size());
  }

  void matVecMult(double x[], double result[]) override {
    const int n = particles.count();
    for (int i = 0; i < 3 * n; ++i) x_free[i] = x[i];
    clear_pinned(particles, x_free);

    Kx.setZero();
    force.add_dfdx(state.x, state.v, x_free, Kx);
    Dx.setZero();
    force.add_dfdv(state.x, state.v, x_free, Dx);

    for (int i = 0; i < n; ++i) {
      for (int j = 3 * i; j < 3 * i + 3; ++j) {
        if (particles.is_pinned(i))
          result[j] = x[j];
        else
          result[j] = particles.mass[i] * x[j] - a * Dx[j] - a * b * Kx[j];
      }
    }
  }

 private:
  const Force& force;
  const Particles& particles;
  const State& state;
  double a, b;
  VectorXd x_free, Kx, Dx;
};

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<Matrix>(force, particles, state, a, b);
}

// (L^-1 A L^-T) y = L^-1 r, dv += L^-T y: three times, if need be.
static SolveReport solve_with(const Preconditioner& L, Matrix& A, const VectorXd& rhs, double tolerance,
                              Output dv) {
  VectorXd r = rhs, y = rhs, work = rhs;
  PreconditionedMatrix better(A, L, work);
  SolveReport report;
  report.preconditioned = true;
  report.rhs = rhs.norm();
  dv.setZero();
  for (int k = 0; k < kMostSolves && !report.converged; ++k) {
    L.solve_lower(r);
    int steps = std::max(100, static_cast<int>(rhs.size()));
    ConjGrad(static_cast<int>(rhs.size()), &better, y.data(), r.data(),
             std::max(tolerance * tolerance, 1e-28) * r.squaredNorm(), &steps);
    report.steps += steps;
    L.solve_lower_transposed(y);
    dv += y;
    A.matVecMult(dv.data(), r.data());
    r = rhs - r;
    report.residual = r.norm();
    report.converged = report.residual <= tolerance * report.rhs ||
                       L.rounding_allows(report.residual, dv.norm(), report.rhs);
  }
  return report;
}

SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch) {
  const int size = 3 * particles.count();

  // rhs = a (f + b K v)
  VectorXd f = VectorXd::Zero(size), Kv = VectorXd::Zero(size);
  force.add_force(state.x, state.v, f);
  force.add_dfdx(state.x, state.v, state.v, Kv);
  VectorXd rhs = a * (f + b * Kv);
  clear_pinned(particles, rhs);

  const Preconditioner preconditioner(force, particles, state, a, b,
                                      scratch.leftCols(kPreconditionerScratch));
  if (preconditioner.exists()) {
    Matrix A(force, particles, state, a, b);
    return solve_with(preconditioner, A, rhs, tolerance, dv);
  }

  SolveReport report;
  report.rhs = rhs.norm();
  const double epsilon = tolerance * tolerance * rhs.squaredNorm();
  report.steps = std::max(100, 20 * size);
  Matrix A(force, particles, state, a, b);
  const double error = ConjGrad(size, &A, dv.data(), rhs.data(), epsilon, &report.steps);
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
