// STAFF ONLY. H4: linearly implicit Euler.

#include "particles/implicit_euler.h"

#include <cmath>

#include "particles/solve_implicit.h"

namespace particles {
namespace {

// M - a df/dv - a b df/dx. Pinned particles have the rows and columns of the identity.
class ImplicitMatrix : public implicitMatrix {
 public:
  ImplicitMatrix(const Force& force, const Particles& particles, const State& state, double a, double b)
      : force_(force), particles_(particles), state_(state), a_(a), b_(b), work_(state.x.size(), 2) {}

  void matVecMult(double x[], double b[]) override {
    const Eigen::Index size = state_.x.size();
    const Eigen::Map<const Eigen::VectorXd> dv(x, size);
    Eigen::Map<Eigen::VectorXd> product(b, size);
    auto free = work_.col(0), moved = work_.col(1);

    free = dv;
    for (int i = 0; i < particles_.count(); ++i)
      if (particles_.is_pinned(i)) free.segment<3>(3 * i).setZero();
    moved = b_ * free;
    product.setZero();
    force_.add_dfdx(state_.x, state_.v, moved, product);
    force_.add_dfdv(state_.x, state_.v, free, product);
    for (int i = 0; i < particles_.count(); ++i) {
      auto entry = product.segment<3>(3 * i);
      if (particles_.is_pinned(i))
        entry = dv.segment<3>(3 * i);
      else
        entry = particles_.mass[i] * dv.segment<3>(3 * i) - a_ * entry;
    }
  }

 private:
  const Force& force_;
  const Particles& particles_;
  const State& state_;
  double a_, b_;
  Eigen::MatrixXd work_;
};

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<ImplicitMatrix>(force, particles, state, a, b);
}

void implicit_rhs(const Force& force, const Particles& particles, const State& state, double a, double b,
                  Output rhs) {
  const Eigen::VectorXd moved = b * state.v;
  rhs.setZero();
  force.add_force(state.x, state.v, rhs);
  force.add_dfdx(state.x, state.v, moved, rhs);
  rhs *= a;
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) rhs.segment<3>(3 * i).setZero();
}

SolveReport solve_plain(implicitMatrix& matrix, Output rhs, double tolerance, int most_steps, Output dv) {
  SolveReport report;
  report.rhs = rhs.norm();
  report.steps = most_steps;
  const double epsilon = std::pow(tolerance * report.rhs, 2);
  const double squared =
      ConjGrad(static_cast<int>(rhs.size()), &matrix, dv.data(), rhs.data(), epsilon, &report.steps);
  report.residual = std::sqrt(squared);
  report.converged = squared <= epsilon;
  return report;
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch) {
  auto dv = scratch.col(kImplicitScratch - 1);
  const SolveReport report = solve_implicit(force, particles, state, h, h, tolerance, dv, scratch);
  state.v += dv;
  state.x += h * state.v;
  return report;
}

}  // namespace particles
