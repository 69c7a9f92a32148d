// STAFF ONLY. A right H4 that writes its matrix out as a table, by products with unit vectors.
#include "particles/implicit_euler.h"

#include <cmath>
#include <vector>

#include "particles/solve_implicit.h"

namespace particles {
namespace {

class Table : public implicitMatrix {
 public:
  Table(const Force& force, const Particles& particles, const State& state, double a, double b)
      : size_(state.x.size()), entries_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_)) {
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(size_), along_x(size_), along_v(size_);
    for (Eigen::Index j = 0; j < size_; ++j) {
      entry(j, j) = 1;
      if (is_pinned(particles, j)) continue;
      unit[j] = 1;
      along_x.setZero();
      along_v.setZero();
      force.add_dfdx(state.x, state.v, unit, along_x);
      force.add_dfdv(state.x, state.v, unit, along_v);
      unit[j] = 0;
      entry(j, j) = particles.mass[j / 3];
      for (Eigen::Index i = 0; i < size_; ++i)
        if (!is_pinned(particles, i)) entry(i, j) -= a * along_v[i] + a * b * along_x[i];
    }
  }

  void matVecMult(double x[], double b[]) override {
    for (Eigen::Index i = 0; i < size_; ++i) {
      double sum = 0;
      for (Eigen::Index j = 0; j < size_; ++j) sum += entry(i, j) * x[j];
      b[i] = sum;
    }
  }

  static bool is_pinned(const Particles& particles, Eigen::Index row) {
    return particles.is_pinned(static_cast<int>(row / 3));
  }

 private:
  double& entry(Eigen::Index i, Eigen::Index j) { return entries_[static_cast<std::size_t>(i * size_ + j)]; }

  Eigen::Index size_;
  std::vector<double> entries_;
};

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<Table>(force, particles, state, a, b);
}

void implicit_rhs(const Force& force, const Particles& particles, const State& state, double a, double b,
                  Output rhs) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(state.x.size()), Kv = f;
  force.add_force(state.x, state.v, f);
  force.add_dfdx(state.x, state.v, state.v, Kv);
  for (Eigen::Index i = 0; i < f.size(); ++i)
    rhs[i] = Table::is_pinned(particles, i) ? 0 : a * f[i] + a * b * Kv[i];
}

SolveReport solve_plain(implicitMatrix& matrix, Output rhs, double tolerance, int most_steps, Output dv) {
  Eigen::VectorXd right = rhs;  // a copy for ConjGrad
  double epsilon = 0;
  for (double number : right) epsilon += number * number;
  SolveReport report{most_steps, 0, std::sqrt(epsilon), false, false};
  epsilon *= tolerance * tolerance;
  const double squared =
      ConjGrad(static_cast<int>(right.size()), &matrix, dv.data(), right.data(), epsilon, &report.steps);
  report.residual = std::sqrt(squared);
  report.converged = squared <= epsilon;
  return report;
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch) {
  Eigen::VectorXd dv(state.v.size());
  const SolveReport report = solve_implicit(force, particles, state, h, h, tolerance, dv, scratch);
  for (Eigen::Index i = 0; i < dv.size(); ++i) {
    state.v[i] += dv[i];
    state.x[i] += h * state.v[i];
  }
  return report;
}

}  // namespace particles
