// STAFF ONLY. The books of a strand's energy: what comes in by roots, frames, drag and obstacles is no gain; what comes
// from nowhere is.
#include "hair/mass_spring/energy_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/simulation/simulation.h"
#include "hair/simulation/tests/hairs.h"

namespace reference_tests {
namespace {

using hair::Concern;

// Ten segments of hair in a tenth of a metre, level, under gravity, in steps of which H6 makes small errors.
Description swing(Method method, double step) {
  Description description = alone(straight_hair(10, 0.1, Vector3d::UnitX()), method, step);
  description.gravity = kG * kDown;
  return description;
}

double largest_of(const Simulation& simulation, Concern concern) {
  return simulation.watch().worst(concern);
}

double energy(const Simulation& simulation) {
  const particles::State& state = simulation.state(0);
  return simulation.body(0).measure(state.x, state.v).energy();
}

// m g L
double weight(const Simulation& simulation) {
  return simulation.strand(0).mass.sum() * kG * simulation.strand(0).rest_length.sum();
}

// A root that is shaken at 2 m/s gives the strand many times m g L, and none of it is a gain: methods of order one
// may be off by a few h of a second's motion.
TEST(EnergyWatch, TheWorkOfAShakenRootIsNoGain) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    Simulation simulation(swing(method, 1e-3));
    double most = 0;
    for (int k = 0; k < 400; ++k) {
      const double phase = 0.05 * k;
      simulation.set_root_velocity(0, 2 * Vector3d(std::sin(phase), std::cos(2 * phase), std::cos(phase)));
      ASSERT_FALSE(simulation.step());
      most = std::max(most, energy(simulation));
    }
    EXPECT_GT(most, 5 * weight(simulation));
    EXPECT_LE(largest_of(simulation, Concern::energy), 0.02) << name_of(method);
  }
}

// The same in a frame that moves: who is at rest does not matter.
TEST(EnergyWatch, IsTheSameInAFrameThatMoves) {
  const auto gain = [](const Vector3d& velocity) {
    Description description = swing(Method::predictor_corrector, 1.0 / 30);
    description.gravity *= 100;  // gains energy
    description.strands[0].state.v = velocity.replicate(11, 1);
    Simulation simulation(description);
    simulation.advance(20);
    return largest_of(simulation, Concern::energy);
  };
  const double at_rest = gain(Vector3d::Zero());
  EXPECT_GT(at_rest, 1e-3);
  // Velocities of 64 m/s round by 2^-46 m/s, which the motion makes larger.
  EXPECT_NEAR(gain(Vector3d(0, 64, 0)) / at_rest, 1, 1e-6);
}

TEST(EnergyWatch, TheWorkOfWindAndOfATurningFrameIsNoGain) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    Description description = swing(method, 1e-3);
    description.strands[0].strand.clamped = true;
    description.strands[0].strand.root_tangent = Vector3d::UnitX();
    description.drag = 1e-3;
    description.wind = Vector3d(0, 5, 0);
    Simulation simulation(std::move(description));
    for (int k = 1; k <= 400; ++k) {
      const double angle = 0.01 * k;
      simulation.set_root_frame(0, {std::cos(angle), std::sin(angle), 0}, Vector3d::UnitZ());
      ASSERT_FALSE(simulation.step());
    }
    EXPECT_GT(energy(simulation), 0);
    EXPECT_LE(largest_of(simulation, Concern::energy), 0.02) << name_of(method);
  }
}

// A ball hits hair at 2 m/s: what makes a part of it as fast comes from there. What is
// pushed out has its bends from nowhere, but these are small.
TEST(EnergyWatch, TheWorkOfAnObstacleIsNoGain) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    Description description = swing(method, 1e-3);
    description.obstacles = {{hair::Sphere{Vector3d(0.07, -0.021, 0), 0.02}, 0.3, Vector3d(0, 2, 0)}};
    Simulation simulation(std::move(description));
    ASSERT_FALSE(simulation.advance(60));
    EXPECT_GT(simulation.work().contacts, 5);
    const particles::State& state = simulation.state(0);
    EXPECT_GT(simulation.body(0).measure(state.x, state.v).kinetic, 0.15 * weight(simulation))
        << name_of(method);
    EXPECT_LE(largest_of(simulation, Concern::energy), 0.02) << name_of(method);
    EXPECT_LE(largest_of(simulation, Concern::contact_energy), 0.02) << name_of(method);
  }
}

// Where nothing happens, there are roundings alone.
TEST(EnergyWatch, RoundingIsNoGain) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    Description description = swing(method, 1.0 / 240);
    description.gravity.setZero();
    description.strands[0].strand.clamped = true;
    description.strands[0].strand.root_tangent = Vector3d(0.6, 0.8, 0);
    for (int i = 1; i <= 10; ++i)
      description.strands[0].state.x.segment<3>(3 * i) = 0.01 * i * Vector3d(0.6, 0.8, 0);
    Simulation simulation(std::move(description));
    ASSERT_FALSE(simulation.advance(100));
    EXPECT_TRUE(simulation.watch().warnings().empty());
    EXPECT_LE(largest_of(simulation, Concern::energy), 1e-9) << name_of(method);
  }
}

// Who is thrown by a hand between two steps starts anew; and who is not watched is not asked.
TEST(EnergyWatch, BeginsAnewWithAnotherState) {
  Simulation simulation(swing(Method::predictor_corrector, 1e-3));
  ASSERT_FALSE(simulation.advance(10));
  Eigen::VectorXd x(33), v(33);
  simulation.body(0).read(x, v);
  v.tail(30) = Vector3d(0, 10, 0).replicate(10, 1);
  simulation.body(0).write(x, v);
  ASSERT_FALSE(simulation.advance(10));
  EXPECT_LE(largest_of(simulation, Concern::energy), 0.02);

  Description wild = swing(Method::predictor_corrector, 1.0 / 240);
  wild.gravity *= 1e5;
  Simulation watched(wild);
  ASSERT_FALSE(watched.advance(20));
  EXPECT_FALSE(watched.watch().warnings().empty());
  wild.watched = false;
  Simulation unwatched(wild);
  ASSERT_FALSE(unwatched.advance(20));
  EXPECT_TRUE(unwatched.watch().warnings().empty());
  EXPECT_EQ(watched.state(0).x, unwatched.state(0).x);
}

}  // namespace
}  // namespace reference_tests
