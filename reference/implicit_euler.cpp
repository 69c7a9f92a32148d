// STAFF ONLY. H4: linearly implicit Euler.

#include "particles/implicit_euler.h"

#include <algorithm>
#include <cmath>

#include "particles/preconditioner.h"

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

// a (f + b df/dx v)
void right_hand_side(const Force& force, const Particles& particles, const State& state, double a, double b,
                     Output moved, Output rhs) {
  moved = b * state.v;
  rhs.setZero();
  force.add_force(state.x, state.v, rhs);
  force.add_dfdx(state.x, state.v, moved, rhs);
  rhs *= a;
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) rhs.segment<3>(3 * i).setZero();
}

// Of what is tried where rounding keeps a solve from its tolerance: at 1e-4 hair loses gravity.
constexpr double kLoosestTolerance = 1e-6;
constexpr double kTightestTolerance = 1e-14;  // the second try's, for a tolerance of 0

SolveReport solve_plain(implicitMatrix& matrix, double tolerance, Output rhs, Output dv) {
  const int size = static_cast<int>(rhs.size()), most = std::max(100, 20 * size);
  SolveReport report;
  report.rhs = rhs.norm();
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

// Each solve of L^-1 A L^-T y = L^-1 r takes away what the earlier ones left of r. `work` has three columns.
SolveReport solve_preconditioned(implicitMatrix& matrix, const Preconditioner& preconditioner,
                                 double tolerance, Input rhs, Output dv, Scratch work) {
  const int size = static_cast<int>(rhs.size());
  auto left = work.col(0), y = work.col(1);
  PreconditionedMatrix near_identity(matrix, preconditioner, work.col(2));
  SolveReport report;
  report.preconditioned = true;
  report.rhs = report.residual = rhs.norm();
  dv.setZero();
  left = rhs;
  for (int solve = 0; solve < kMostSolves && !report.converged; ++solve) {
    preconditioner.solve_lower(left);
    int steps = std::max(100, size);
    const double epsilon = std::pow(std::max(tolerance, kTightestTolerance) * left.norm(), 2);
    ConjGrad(size, &near_identity, y.data(), left.data(), epsilon, &steps);
    report.steps += steps;
    preconditioner.solve_lower_transposed(y);
    dv += y;
    matrix.matVecMult(dv.data(), left.data());
    left = rhs - left;
    const double residual = left.norm();
    if (!(residual < report.residual || residual == 0)) {  // no nearer
      dv -= y;
      break;
    }
    report.residual = residual;
    report.converged =
        residual <= tolerance * report.rhs || preconditioner.rounding_allows(residual, dv.norm(), report.rhs);
  }
  return report;
}

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<OwningImplicitMatrix>(force, particles, state, a, b);
}

SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch) {
  auto rhs = scratch.col(2);
  right_hand_side(force, particles, state, a, b, scratch.col(3), rhs);
  ImplicitMatrix matrix(force, particles, state, a, b, scratch.leftCols(2));
  const Preconditioner preconditioner(force, particles, state, a, b,
                                      scratch.middleCols(6, kPreconditionerScratch));
  if (!preconditioner.exists()) return solve_plain(matrix, tolerance, rhs, dv);
  return solve_preconditioned(matrix, preconditioner, tolerance, rhs, dv, scratch.middleCols(3, 3));
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
