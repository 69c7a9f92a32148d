// STAFF ONLY. Rods and wires in motion, integrated by RK4, against closed forms of mechanics; and solves that
// have no solution.
#include "reference/P2/constrained_motion_for_tests.h"
#include "solver/test_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/explicit_integrators.h"
#include "particles/system.h"

namespace reference_tests {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

void weigh(ConstrainedMotion& motion) {
  motion.f = VectorXd::Zero(motion.state.x.size());
  for (int i = 0; i < motion.particles.count(); ++i)
    motion.f[3 * i + 2] = -kGravity * motion.particles.mass[i];
}

// Particle 1 on a rod from particle 0, `angle` from straight down, at rest.
ConstrainedMotion pendulum(double length, double mass, double angle) {
  ConstrainedMotion motion;
  motion.constraints.rods = {{1, 0, length}};
  motion.particles = {Vector2d(1, mass), {1, 0}};
  motion.state = {VectorXd::Zero(6), VectorXd::Zero(6)};
  motion.state.x.tail<3>() = length * Vector3d(std::sin(angle), 0, -std::cos(angle));
  weigh(motion);
  return motion;
}

// A bead on an upright wire around the origin, `angle` from its lowest point.
ConstrainedMotion bead(double radius, double mass, double angle) {
  ConstrainedMotion motion;
  motion.constraints.wires = {{0, Vector3d::Zero(), Vector3d(0, 1, 0), radius}};
  motion.particles = {VectorXd::Constant(1, mass), {0}};
  motion.state = {radius * Vector3d(std::sin(angle), 0, -std::cos(angle)), VectorXd::Zero(3)};
  weigh(motion);
  return motion;
}

ConstrainedMotion double_pendulum() {
  ConstrainedMotion motion = straight_chain(3, 0.5);
  weigh(motion);
  return motion;
}

double energy(const ConstrainedMotion& motion) {
  return particles::kinetic_energy(motion.particles, motion.state.v) - motion.f.dot(motion.state.x);
}

void step(ConstrainedMotion& motion, double h) {
  MatrixXd scratch(motion.state.x.size(), particles::kIntegratorScratch);
  particles::State state = motion.state;
  particles::runge_kutta_4(motion, h, state.x, state.v, scratch);
  motion.state = state;
}

TEST(Energy, IsKeptToTheIntegratorsOrder) {
  const auto worst = [](ConstrainedMotion motion, double h, double* off) {
    const double before = energy(motion);
    double change = 0;
    for (int i = 0; i < static_cast<int>(std::lround(10 / h)); ++i) {
      step(motion, h);
      change = std::max(change, std::abs(energy(motion) - before));
      *off = std::max(*off, motion.values().norm());
    }
    return change;
  };
  for (const auto& [name, motion] : {std::pair{"pendulum", pendulum(0.5, 2, 2)},
                                     {"bead", bead(0.5, 2, 2)},
                                     {"double pendulum", double_pendulum()}}) {
    double off_coarse = 0, off_fine = 0;
    const double coarse = worst(motion, 1.0 / 250, &off_coarse), fine = worst(motion, 1.0 / 500, &off_fine);
    std::printf("%s, 10 s: energy off by %.2e and %.2e J, C by %.1e and %.1e m^2 at h = 1/250 and 1/500\n",
                name, coarse, fine, off_coarse, off_fine);
    // The bound is a part of m g L summed up, 10 to 20 J. Half the step divides RK4's error by 16.
    EXPECT_LE(fine, 2e-4) << name;
    EXPECT_LE(fine, coarse / 14) << name;
    EXPECT_LE(off_fine, 1e-4) << name;
  }
}

TEST(Feedback, TakesErrorsAwayAsADampedOscillatorDoes) {
  // C'' = -stiffness C - damping C', whatever else goes on: here a swing with a rod that is 5 % too long.
  const double rate = 8, h = 1e-3;
  for (const auto& [stiffness, damping] :
       {std::pair{rate * rate, 2 * rate}, {rate * rate, 0.0}, {0.0, rate}}) {
    ConstrainedMotion motion = double_pendulum();
    motion.constraints.stiffness = stiffness;
    motion.constraints.damping = damping;
    motion.constraints.rods[0].length *= 1 / 1.05;
    motion.state.v.segment<3>(3) = Vector3d(0.3, 0.2, 0);
    const double C = motion.values()[0], Ct = motion.rates()[0];
    for (int i = 1; i <= 1000; ++i) {
      step(motion, h);
      const double t = i * h, e = std::exp(-rate * t);
      const double expected = damping == 0     ? C * std::cos(rate * t) + Ct / rate * std::sin(rate * t)
                              : stiffness == 0 ? C + Ct / rate * (1 - e)
                                               : (C + (Ct + rate * C) * t) * e;
      ASSERT_NEAR(motion.values()[0], expected, 1e-9) << "t = " << t << ", " << stiffness << ", " << damping;
    }
  }
}

// Two rods of different lengths pull in one direction: no lambda leaves less than half of their rows'
// difference in each of them.
TEST(SolveConstraints, EndsForContradictionsAndSaysHowFarItCame) {
  ConstrainedMotion motion = double_pendulum();
  motion.constraints.stiffness = 100;
  motion.constraints.rods.push_back({0, 1, 1.5});
  const particles::ConstraintReport report = motion.solve();
  const VectorXd C = motion.values();
  EXPECT_GE(report.residual, 0.99 * 100 * std::abs(C[0] - C[2]) / std::sqrt(2.0));
  EXPECT_TRUE(motion.lambda.allFinite());
  EXPECT_LE(report.steps, 3 * 100) << "three tolerances, each with as many iterations as the header allows";
}

TEST(SolveConstraints, EndsForNumbersThatAreNotFinite) {
  ConstrainedMotion motion = double_pendulum();
  motion.f[4] = kNaN;
  EXPECT_FALSE(motion.solve().residual <= 1e-5);
}

}  // namespace
}  // namespace reference_tests
