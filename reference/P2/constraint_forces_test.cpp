// STAFF ONLY. Constraints that rigid motion carries along, that repeat or contradict each other, and the
// ends of their solves. The public checks test the promises of particles/constraint_forces.h.

#include "particles/constraint_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/P2/constrained_motion_for_tests.h"
#include "solver/test_numbers.h"

namespace reference_tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Five particles, about 1 apart, in a chain with a cross rod and two wires. No constraint holds. Particle 4
// is pinned.
ConstrainedMotion tangle() {
  ConstrainedMotion motion;
  motion.constraints.rods = {{0, 1, 0.7}, {2, 1, 1.1}, {3, 2, 0.9}, {1, 4, 0.4}};
  motion.constraints.wires = {{3, Vector3d(0.2, -1, 0.5), Vector3d(0.6, 0, -0.8), 0.8},
                              {0, Vector3d(-1, 0.3, 0.1), Vector3d(0, 1, 0), 1.5}};
  motion.particles = {(VectorXd(5) << 0.3, 2, 0.7, 5, 1.1).finished(), {0, 0, 0, 0, 1}};
  motion.state.x.resize(15);
  motion.state.x << 0.1, 0, 0.2, 1, 0.3, -0.1, 1.4, 1.2, 0, 0.8, 1.6, 0.9, 0.7, -0.5, -0.6;
  motion.state.v.resize(15);
  motion.state.v << 1, -0.4, 0.3, 0.2, 0.9, -1.1, 0, 0.4, 0.7, -0.6, 0.2, 0.1, 0.5, -0.2, 0.3;
  motion.f.resize(15);
  motion.f << 3, -1, 2, 0, -5, 1, 4, 2, -2, 1, 1, -3, 6, 0, 2;
  return motion;
}

TEST(SolveConstraints, TakesAsManyStepsAsAChainHasRods) {
  for (int n : {2, 10, 50, 200}) {
    ConstrainedMotion chain = straight_chain(n, 0.1);
    chain.f = VectorXd::LinSpaced(3 * n, -1, 1);
    const particles::ConstraintReport report = chain.solve();
    std::printf("chain of %d particles: %d steps\n", n, report.steps);
    // In exact arithmetic ConjGrad takes at most as many steps as there are rows.
    EXPECT_LE(report.steps, n + 2);
    EXPECT_GT(report.steps, 0);
  }
}

TEST(Redundant, AllDistancesOfARigidBodyAgree) {
  // Six particles have fifteen rods; a rigid body needs twelve of them. It spins, without any force.
  ConstrainedMotion body;
  body.particles = {VectorXd(6), std::vector<char>(6, 0)};
  body.particles.mass << 0.3, 2, 0.7, 5, 1.1, 0.5;
  body.state = {VectorXd(18), VectorXd(18)};
  body.state.x << 0, 0, 0, 1, 0, 0.2, 0, 1.1, 0, 0.3, 0.2, 1, 1.2, 0.9, 0.8, -0.7, 0.4, 0.5;
  const Vector3d spin(0.5, -1, 2);
  for (int i = 0; i < 6; ++i)
    body.state.v.segment<3>(3 * i) = spin.cross(Vector3d(body.state.x.segment<3>(3 * i)));
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      body.constraints.rods.push_back(
          {i, j, (body.state.x.segment<3>(3 * i) - body.state.x.segment<3>(3 * j)).norm()});
  body.f = VectorXd::Zero(18);
  const particles::ConstraintReport report = body.solve();
  EXPECT_LE(report.residual, 1e-10 * body.right_hand_side().norm());
  const VectorXd a = body.accelerations();
  EXPECT_LE((body.jacobian() * a + body.curvature()).norm(), 1e-9 * a.norm());
}

TEST(Redundant, RodsThatHoldNothingDoNothing) {
  ConstrainedMotion with = tangle(), without = tangle();
  with.state.x.segment<3>(6) = without.state.x.segment<3>(6) = with.state.x.segment<3>(9);
  with.state.v.segment<3>(6) = without.state.v.segment<3>(6) = with.state.v.segment<3>(9);
  with.constraints.rods[2].length = 0;  // 3 and 2 are in one place, and move together
  without.constraints.rods.erase(without.constraints.rods.begin() + 2);
  EXPECT_LE(with.solve().residual, 1e-10 * with.right_hand_side().norm());
  without.solve();
  EXPECT_LE((with.accelerations() - without.accelerations()).norm(), 1e-7 * with.accelerations().norm());
}

TEST(Redundant, ContradictionsEndAndSayHowFarTheyCame) {
  ConstrainedMotion motion = tangle();
  motion.constraints.stiffness = 100;
  motion.constraints.rods.push_back({0, 1, 1.7});
  const particles::ConstraintReport report = motion.solve();
  const VectorXd rhs = motion.right_hand_side();
  // No lambda can leave less than half of the difference of the two rows.
  EXPECT_GE(report.residual, 0.99 * std::abs(rhs[0] - rhs[4]) / std::sqrt(2.0));
  EXPECT_TRUE(motion.lambda.allFinite());
  EXPECT_LE(report.steps, 180);
}

TEST(SolveConstraints, EndsForNumbersThatAreNotFinite) {
  ConstrainedMotion motion = tangle();
  motion.f[4] = kNaN;
  EXPECT_FALSE(motion.solve().residual <= 1e-5);
}

}  // namespace
}  // namespace reference_tests
