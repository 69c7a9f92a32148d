// STAFF ONLY. Moves particles under P2's constraints.
#include "reference/P2/constrained_motion_for_tests.h"

namespace reference_tests {

using Eigen::VectorXd;

void ConstrainedMotion::acceleration(particles::Input x, particles::Input v, particles::Output a) {
  state = {x, v};
  solve();
  a = accelerations();
}

VectorXd ConstrainedMotion::values() const {
  VectorXd C(constraints.rows());
  particles::constraint_values(constraints, state.x, C);
  return C;
}

VectorXd ConstrainedMotion::rates() const {
  VectorXd result(constraints.rows());
  particles::constraint_rates(constraints, state.x, state.v, result);
  return result;
}

VectorXd ConstrainedMotion::forces(const VectorXd& multipliers) const {
  VectorXd result = VectorXd::Zero(state.x.size());
  particles::add_constraint_forces(constraints, state.x, multipliers, result);
  return result;
}

particles::ConstraintReport ConstrainedMotion::solve() {
  lambda.setConstant(constraints.rows(), 1e3);
  return particles::solve_constraints(constraints, particles, state, f, lambda);
}

VectorXd ConstrainedMotion::accelerations() const {
  VectorXd a = f + forces(lambda);
  for (int i = 0; i < particles.count(); ++i) {
    if (particles.is_pinned(i))
      a.segment<3>(3 * i).setZero();
    else
      a.segment<3>(3 * i) /= particles.mass[i];
  }
  return a;
}

ConstrainedMotion straight_chain(int n, double length) {
  ConstrainedMotion chain;
  chain.particles = {VectorXd::Ones(n), std::vector<char>(n, 0)};
  chain.particles.pinned[0] = 1;
  chain.state = {VectorXd::Zero(3 * n), VectorXd::Zero(3 * n)};
  for (int i = 0; i < n; ++i) {
    chain.particles.mass[i] = 1 + i % 2;
    chain.state.x[3 * i] = i * length;
  }
  for (int i = 0; i + 1 < n; ++i) chain.constraints.rods.push_back({i, i + 1, length});
  chain.f = VectorXd::Zero(3 * n);
  return chain;
}

}  // namespace reference_tests
