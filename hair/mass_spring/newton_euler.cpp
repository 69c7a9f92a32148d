#include "hair/mass_spring/newton_euler.h"

#include <algorithm>
#include <cmath>

#include "particles/implicit_euler.h"

namespace hair {

namespace {

using particles::Force, particles::Particles, particles::State;
using Column = Eigen::Ref<Eigen::VectorXd>;

constexpr int kMostNewtonSteps = 30;
constexpr int kMostHalvings = 30;
constexpr double kSame = 1e-12;         // of the largest velocity
constexpr double kSamePlace = 0x1p-50;  // of the largest position: a few roundings

// Of a solve. What it leaves is the next Newton step's: three make 1e-18.
constexpr double kSolve = 1e-6;

class Step {
 public:
  Step(const Particles& particles, double h, State& state, particles::Scratch scratch)
      : particles_(particles),
        h_(h),
        state_(state),
        x_(scratch.col(0)),
        v_(scratch.col(1)),
        left_(scratch.col(2)),
        change_(scratch.col(3)),
        before_(scratch.col(4)),
        work_(scratch.rightCols(particles::kPreconditionerScratch + 2)) {
    x_ = state.x;
    v_ = state.v;
  }

  NewtonReport run(const Force& force, const Force& definite) {
    NewtonReport report;
    go_to(force, v_);
    while (report.newton_steps < kMostNewtonSteps && !report.converged && left_.allFinite()) {
      ++report.newton_steps;
      if (!solve(force, report)) {
        ++report.definite_steps;
        solve(definite, report);
      }
      if (!change_.allFinite()) break;
      before_ = state_.v;
      const double most = std::max(kSame * before_.lpNorm<Eigen::Infinity>(),
                                   kSamePlace * state_.x.lpNorm<Eigen::Infinity>() / h_);
      report.converged = change_.lpNorm<Eigen::Infinity>() <= most;
      const double slope = left_.dot(change_);  // down, if > 0
      double part = 1;
      go_to(force, before_ + change_);
      for (int k = 0; k < kMostHalvings && !report.converged && too_far(slope); ++k) {
        part /= 2;
        ++report.halvings;
        go_to(force, before_ + part * change_);
      }
    }
    return report;
  }

 private:
  // The state that the velocities u lead to, and M (v - u) + h f there: what is left to solve.
  template <typename Velocities>
  void go_to(const Force& force, const Velocities& u) {
    state_.v = u;
    state_.x = x_ + h_ * state_.v;
    left_.setZero();
    force.add_force(state_.x, state_.v, left_);
    for (int i = 0; i < particles_.count(); ++i) {
      auto left = left_.segment<3>(3 * i);
      if (particles_.is_pinned(i))
        left.setZero();
      else
        left = h_ * left + particles_.mass[i] * (v_.segment<3>(3 * i) - state_.v.segment<3>(3 * i));
    }
  }

  // Where the way that went down goes up as steeply; also where forces are not finite.
  bool too_far(double slope) const { return !(-left_.dot(change_) <= 0.9 * std::abs(slope)); }

  // change_ = matrix^-1 left_; false if ConjGrad found the matrix not definite.
  bool solve(const Force& force, NewtonReport& report) {
    const auto matrix = particles::implicit_matrix(force, particles_, state_, h_, h_);
    const int size = static_cast<int>(left_.size()), most = std::max(100, 20 * size);
    const auto solve = [&](implicitMatrix* A, double* b) {
      const double epsilon = std::pow(kSolve * Eigen::Map<Eigen::VectorXd>(b, size).norm(), 2);
      int steps = most;
      const double squared = ConjGrad(size, A, change_.data(), b, epsilon, &steps);
      report.solver_steps += steps;
      return squared <= epsilon || steps == most;
    };
    const particles::Preconditioner preconditioner(force, particles_, state_, h_, h_,
                                                   work_.rightCols(particles::kPreconditionerScratch));
    if (!preconditioner.exists()) {
      ++report.plain_solves;
      return solve(matrix.get(), left_.data());
    }
    auto right = work_.col(0);
    particles::PreconditionedMatrix near_identity(*matrix, preconditioner, work_.col(1));
    right = left_;
    preconditioner.solve_lower(right);
    const bool solved = solve(&near_identity, right.data());
    preconditioner.solve_lower_transposed(change_);
    return solved;
  }

  const Particles& particles_;
  double h_;
  State& state_;
  Column x_, v_, left_, change_, before_;
  particles::Scratch work_;
};

}  // namespace

NewtonReport newton_euler(const Force& force, const Force& definite, const Particles& particles, double h,
                          State& state, particles::Scratch scratch) {
  return Step(particles, h, state, scratch).run(force, definite);
}

}  // namespace hair
