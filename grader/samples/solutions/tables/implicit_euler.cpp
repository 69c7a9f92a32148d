// STAFF ONLY. A right H4 that writes its matrix out as a table, by products with unit vectors, and lets the preconditioner
// help.
#include "particles/implicit_euler.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

// Made when the first product is asked for.
class LateTable : public implicitMatrix {
 public:
  LateTable(const Force& force, const Particles& particles, const State& state, double a, double b)
      : force_(force), particles_(particles), state_(state), a_(a), b_(b) {}
  void matVecMult(double x[], double b[]) override {
    if (!table_) table_ = std::make_unique<Table>(force_, particles_, state_, a_, b_);
    table_->matVecMult(x, b);
  }

 private:
  const Force& force_;
  const Particles& particles_;
  const State& state_;
  double a_, b_;
  std::unique_ptr<Table> table_;
};

Eigen::VectorXd right_side(const Force& force, const Particles& particles, const State& state, double a,
                           double b) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(state.x.size()), Kv = f;
  force.add_force(state.x, state.v, f);
  force.add_dfdx(state.x, state.v, state.v, Kv);
  for (Eigen::Index i = 0; i < f.size(); ++i)
    f[i] = Table::is_pinned(particles, i) ? 0 : a * f[i] + a * b * Kv[i];
  return f;
}

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<LateTable>(force, particles, state, a, b);
}

SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch) {
  Eigen::VectorXd rhs = right_side(force, particles, state, a, b);
  const int size = static_cast<int>(rhs.size());
  LateTable matrix(force, particles, state, a, b);
  SolveReport report;
  report.rhs = rhs.norm();

  const Preconditioner preconditioner(force, particles, state, a, b,
                                      scratch.leftCols(kPreconditionerScratch));
  if (!preconditioner.exists()) {
    const double epsilon = std::pow(tolerance * report.rhs, 2);
    report.steps = std::max(100, 20 * size);
    const double squared = ConjGrad(size, &matrix, dv.data(), rhs.data(), epsilon, &report.steps);
    report.residual = std::sqrt(squared);
    report.converged = squared <= epsilon;
    return report;
  }

  report.preconditioned = true;
  Eigen::VectorXd work(size), y(size), left = rhs;
  PreconditionedMatrix inner(matrix, preconditioner, work);
  report.residual = report.rhs;
  dv.setZero();
  for (int solve = 0; solve < kMostSolves; ++solve) {
    Eigen::VectorXd right = left;
    preconditioner.solve_lower(right);
    int steps = std::max(100, size);
    const double epsilon = right.squaredNorm() * std::pow(std::max(tolerance, 1e-14), 2);
    ConjGrad(size, &inner, y.data(), right.data(), epsilon, &steps);
    report.steps += steps;
    preconditioner.solve_lower_transposed(y);
    Eigen::VectorXd sum = dv + y, product(size);
    matrix.matVecMult(sum.data(), product.data());
    const double residual = (rhs - product).norm();
    if (!(residual < report.residual) && residual != 0) break;
    dv = sum;
    left = rhs - product;
    report.residual = residual;
    report.converged =
        residual <= tolerance * report.rhs || preconditioner.rounding_allows(residual, dv.norm(), report.rhs);
    if (report.converged) break;
  }
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
