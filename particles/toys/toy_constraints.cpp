#include <algorithm>

#include "particles/constraint_forces.h"
#include "particles/toys/constraint_rounding.h"
#include "particles/toys/toy_methods.h"

namespace particles {

namespace {

// The largest residual of a solve that counts as finished, relative to the right-hand side. P2 may stop this
// early if constraints are redundant.
constexpr double kMostLeft = 1e-6;

// a = W (f + J^T lambda): all forces including those of the constraints. P2 solves for lambda.
class ConstrainedDynamics : public Dynamics {
 public:
  ConstrainedDynamics(MovingToy& moving, bool watched)
      : watched_(watched),
        particles_(moving.toy.particles),
        constraints_(moving.toy.constraints),
        force_(moving.force),
        solves_(moving.solves),
        state_(moving.state),
        sum_(constraints_.rows()),
        term_(constraints_.rows()),
        lambda_(Eigen::VectorXd::Zero(constraints_.rows())) {}

  void acceleration(Input x, Input v, Output a) override {
    state_.x = x;
    state_.v = v;
    a.setZero();
    force_.add_force(x, v, a);
    const double rounding = constraint_rounding(constraints_, particles_, state_, a);
    free_ = a;
    divide_by_mass(free_);
    const double before = error(free_);
    if (before <= rounding) {  // there is nothing to solve
      a = free_;
      return;
    }
    solves_.steps += solve_constraints(constraints_, particles_, state_, a, lambda_).steps;
    ++solves_.solves;
    add_constraint_forces(constraints_, x, lambda_, a);
    divide_by_mass(a);
    if (watched_) watch(before, error(a), rounding);
  }

 private:
  void divide_by_mass(Output f) const {
    for (int i = 0; i < particles_.count(); ++i) {
      if (particles_.is_pinned(i)) {
        f.segment<3>(3 * i).setZero();
      } else {
        f.segment<3>(3 * i) /= particles_.mass[i];
      }
    }
  }

  void watch(double before, double left, double rounding) {
    if (left <= std::max(kMostLeft * before, rounding)) return;
    ++solves_.unconverged;
    solves_.left = std::max(solves_.left, left / before);
  }

  // The norm of C'' + stiffness C + damping C' for these accelerations. With the other forces' accelerations
  // it is that of the right-hand side; with the constraints' forces it is the residual of the solve.
  double error(Input a) {
    const auto& [rods, wires, stiffness, damping] = constraints_;
    constraint_rates(constraints_, state_.x, a, sum_);
    constraint_values(constraints_, state_.x, term_);
    sum_ += stiffness * term_;
    constraint_rates(constraints_, state_.x, state_.v, term_);
    sum_ += damping * term_;
    int row = 0;
    for (const Rod& rod : rods)
      sum_[row++] += (state_.v.segment<3>(3 * rod.i) - state_.v.segment<3>(3 * rod.j)).squaredNorm();
    for (const Wire& wire : wires) {
      sum_[row] += state_.v.segment<3>(3 * wire.i).squaredNorm();
      row += 2;
    }
    return sum_.norm();
  }

  bool watched_;
  const Particles& particles_;
  const Constraints& constraints_;
  const Force& force_;
  SolveCount& solves_;
  State state_;
  Eigen::VectorXd free_, sum_, term_;
  Eigen::VectorXd lambda_;  // 0 at first: an exercise that wrongly reads it gets the same value in each run
};

}  // namespace

std::unique_ptr<Dynamics> constrained_dynamics(MovingToy& moving, bool watched) {
  return std::make_unique<ConstrainedDynamics>(moving, watched);
}

}  // namespace particles
