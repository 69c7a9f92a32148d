#include <algorithm>
#include <cmath>

#include "particles/constraint_forces.h"
#include "particles/toys/moving_toy.h"

namespace particles {

namespace {

// Rounding in P2's equation. If no force acts on rods and wires, its right-hand side is not 0, but the
// rounding errors of its terms. These contradict each other if constraints are redundant, so no lambda solves
// the equation; and there is nothing to solve.
//
// The norm that the right-hand side of P2's equation may have by rounding alone:
//
//   64 u || for each row the sum of the sizes of its terms ||     u = 2^-53
//
// A term is a sum of up to six products of coordinates that are rounded themselves: 16 u of its size. The
// rest of 64 allows for a few steps. In the size of C a position counts with its distance from the origin,
// because its rounding error is proportional to that.
double constraint_rounding(const Constraints& constraints, const Particles& particles, const State& state,
                           Input f) {
  const auto place = [&](int i) -> double { return state.x.segment<3>(3 * i).norm(); };
  const auto speed = [&](int i) -> double { return state.v.segment<3>(3 * i).norm(); };
  const auto pull = [&](int i) -> double {
    return particles.is_pinned(i) ? 0 : f.segment<3>(3 * i).norm() / particles.mass[i];
  };
  double squared = 0;
  // far: the distance of its ends from the origin; length: that of the row of J for one end.
  const auto add = [&](double length, double far, double at_rest, double speeds, double pulls) {
    const double size = speeds * speeds + length * (pulls + constraints.damping * speeds) +
                        constraints.stiffness * (length * far + at_rest);
    squared += size * size;
  };
  for (const Rod& rod : constraints.rods) {
    const double length = (state.x.segment<3>(3 * rod.i) - state.x.segment<3>(3 * rod.j)).norm();
    add(length, place(rod.i) + place(rod.j), rod.length * rod.length, speed(rod.i) + speed(rod.j),
        pull(rod.i) + pull(rod.j));
  }
  for (const Wire& wire : constraints.wires) {
    const double radius = (state.x.segment<3>(3 * wire.i) - wire.centre).norm();
    const double far = place(wire.i) + wire.centre.norm();
    add(radius, far, wire.radius * wire.radius, speed(wire.i), pull(wire.i));
    add(1, far, 0, speed(wire.i), pull(wire.i));
  }
  return std::ldexp(64, -53) * std::sqrt(squared);
}

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
