// STAFF ONLY. H4: linearly implicit Euler.

#include "particles/implicit_euler.h"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

// M - a df/dv - a b df/dx, with the rows and columns of pinned particles those of the identity. `work` has two
// columns.
class ImplicitMatrix : public implicitMatrix {
 public:
  ImplicitMatrix(const Force& force, const Particles& particles, const State& state, double a, double b,
                 Scratch work)
      : force_(force), particles_(particles), state_(state), a_(a), b_(b), work_(work) {}

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
  Scratch work_;
};

// The same with memory of its own.
class OwningImplicitMatrix : public implicitMatrix {
 public:
  OwningImplicitMatrix(const Force& force, const Particles& particles, const State& state, double a, double b)
      : work_(state.x.size(), 2), matrix_(force, particles, state, a, b, work_) {}
  OwningImplicitMatrix(const OwningImplicitMatrix&) = delete;
  OwningImplicitMatrix& operator=(const OwningImplicitMatrix&) = delete;

  void matVecMult(double x[], double b[]) override { matrix_.matVecMult(x, b); }

 private:
  Eigen::MatrixXd work_;
  ImplicitMatrix matrix_;
};

// Of what is tried where rounding keeps a solve from its tolerance: at 1e-4 hair loses gravity.
constexpr double kLoosestTolerance = 1e-6;
constexpr double kTightestTolerance = 1e-14;  // the second try's, for a tolerance of 0

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<OwningImplicitMatrix>(force, particles, state, a, b);
}

SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch) {
  const int size = static_cast<int>(state.x.size());
  auto rhs = scratch.col(2), moved = scratch.col(3);

  // a (f + b df/dx v)
  moved = b * state.v;
  rhs.setZero();
  force.add_force(state.x, state.v, rhs);
  force.add_dfdx(state.x, state.v, moved, rhs);
  rhs *= a;
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) rhs.segment<3>(3 * i).setZero();

  SolveReport report;
  report.rhs = rhs.norm();
  ImplicitMatrix matrix(force, particles, state, a, b, scratch.leftCols(2));
  const int most = std::max(100, 20 * size);
  for (double reach = tolerance;; reach = std::clamp(100 * reach, kTightestTolerance, kLoosestTolerance)) {
    const double epsilon = std::pow(reach * report.rhs, 2);
    int steps = most;
    const double squared = ConjGrad(size, &matrix, dv.data(), rhs.data(), epsilon, &steps);
    report.steps += steps;
    report.residual = std::sqrt(squared);
    report.converged = reach == tolerance && squared <= epsilon;
    // With all steps used up, rounding is all that ConjGrad sees, and its dv may be far off.
    if (steps < most || squared <= epsilon || reach >= kLoosestTolerance) break;
  }
  return report;
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch) {
  auto dv = scratch.col(4);
  const SolveReport report = solve_implicit(force, particles, state, h, h, tolerance, dv, scratch);
  state.v += dv;
  state.x += h * state.v;
  return report;
}

}  // namespace particles
