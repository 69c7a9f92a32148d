// STAFF ONLY. A right H4 that writes its matrix out: products with unit vectors give its columns, once, and
// then ConjGrad multiplies by the table.
#include "particles/implicit_euler.h"

#include <cmath>

#include "particles/solve_implicit.h"

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

class Dense : public implicitMatrix {
 public:
  Dense(const particles::Force& force, const particles::Particles& particles, const particles::State& state,
        double a, double b)
      : force_(force), particles_(particles), state_(state), a_(a), b_(b) {}

  void matVecMult(double x[], double b[]) override {
    if (table_.size() == 0) fill();
    Eigen::Map<VectorXd>(b, table_.rows()).noalias() = table_ * Eigen::Map<const VectorXd>(x, table_.cols());
  }

 private:
  void fill() {
    const Eigen::Index size = state_.x.size();
    table_.setZero(size, size);
    VectorXd K(size), D(size);
    for (Eigen::Index j = 0; j < size; ++j) {
      if (particles_.is_pinned(static_cast<int>(j / 3))) {
        table_(j, j) = 1;
        continue;
      }
      const VectorXd e = VectorXd::Unit(size, j);
      K.setZero();
      D.setZero();
      force_.add_dfdx(state_.x, state_.v, e, K);
      force_.add_dfdv(state_.x, state_.v, e, D);
      for (Eigen::Index i = 0; i < size; ++i)
        if (!particles_.is_pinned(static_cast<int>(i / 3))) table_(i, j) = -a_ * (D[i] + b_ * K[i]);
      table_(j, j) += particles_.mass[j / 3];
    }
  }

  const particles::Force& force_;
  const particles::Particles& particles_;
  const particles::State& state_;
  double a_, b_;
  MatrixXd table_;
};

}  // namespace

namespace particles {

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<Dense>(force, particles, state, a, b);
}

void implicit_rhs(const Force& force, const Particles& particles, const State& state, double a, double b,
                  Output rhs) {
  const int size = static_cast<int>(state.x.size());
  const VectorXd ahead = b * state.v;
  rhs.setZero();
  force.add_force(state.x, state.v, rhs);
  force.add_dfdx(state.x, state.v, ahead, rhs);
  for (int i = 0; i < size; ++i) rhs[i] = particles.is_pinned(i / 3) ? 0 : a * rhs[i];
}

SolveReport solve_plain(implicitMatrix& matrix, Output rhs, double tolerance, int most_steps, Output dv) {
  const double limit = tolerance * rhs.norm(), epsilon = limit * limit;
  SolveReport report;
  report.rhs = rhs.norm();
  report.steps = most_steps;
  report.residual = std::sqrt(
      ConjGrad(static_cast<int>(rhs.size()), &matrix, dv.data(), rhs.data(), epsilon, &report.steps));
  report.converged = report.residual <= limit;
  return report;
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch) {
  VectorXd dv = VectorXd::Zero(state.v.size());
  const SolveReport report = solve_implicit(force, particles, state, h, h, tolerance, dv, scratch);
  state.v += dv;
  state.x += h * state.v;
  return report;
}

}  // namespace particles
