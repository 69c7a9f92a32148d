// STAFF ONLY. The given simulation among obstacles: they push hair out and along, hold it by friction, and
// preserve H6's lengths and velocities as H6 promises.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hair/simulation/simulation.h"
#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

// With H6 segments keep their lengths in contact, too. What is left is what pushing a particle out by
// kDeepEnough, 1e-7 m, does to a segment of 1 cm, on either side.
TEST(SimulationCollisions, NoParticleIsInsideAnObstacleAfterAStepAndH6KeepsLengths) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    Description description = alone(straight_hair(12, 0.12, Vector3d::UnitX()), method, 1.0 / 240);
    description.gravity = kG * kDown;
    description.strands[0].state.x -= Vector3d(0.04, 0.01, -0.07).replicate(13, 1);
    description.obstacles = {{hair::Sphere{Vector3d(0, 0, 0), 0.06}, 0.3},
                             {hair::Plane{Vector3d(0, 0, 0), Vector3d::UnitZ()}, 0.3}};
    Simulation simulation(std::move(description));
    double stretch = 0;
    for (int step = 0; step < 120; ++step) {
      ASSERT_FALSE(simulation.step());
      stretch = std::max(stretch, hair::largest_stretch(simulation.strand(0), simulation.state(0).x));
      for (int i = 1; i <= 12; ++i)
        for (const hair::Obstacle& obstacle : simulation.obstacles())
          ASSERT_GE(surface_at(obstacle, particle(simulation, i)).distance, -1e-13)
              << name_of(method) << ", step " << step << ", particle " << i;
    }
    EXPECT_GT(simulation.work().contacts, 100) << name_of(method);
    EXPECT_LE(simulation.work().penetration, 1e-13) << name_of(method);
    if (method == Method::predictor_corrector) {
      EXPECT_LE(stretch, 2 * 1e-7 / 0.01);
    }
  }
}

// --- Motion ---

// A segment that resists neither stretching nor bending: only gravity and obstacles move its tip.
StrandStart free_particle(const Vector3d& root, const Vector3d& tip) {
  StrandStart start = straight_hair(1, (tip - root).norm());
  start.strand.stretch_rigidity = start.strand.bend_rigidity = 0;
  start.state.x << root, tip;
  return start;
}

// All methods except H6, which keeps the segment's length.
std::vector<Method> methods_that_stretch() {
  return {kMethods.begin(), kMethods.end() - 1};
}

// The tip is 2 cm in front of an obstacle that moves along x at 3 m/s: after 0.1 s it is at the obstacle's
// front, with its velocity.
TEST(SimulationCollisions, WhatMovesPushesHairAlong) {
  const Vector3d velocity(3, 0, 0);
  const hair::Obstacle fronts[] = {{hair::Plane{Vector3d::Zero(), Vector3d::UnitX()}},
                                   {hair::Sphere{Vector3d(-0.5, 0, 0), 0.5}},
                                   {hair::Capsule{Vector3d(-0.5, 0, -1), Vector3d(-0.5, 0, 1), 0.5}}};
  for (Method method : methods_that_stretch())
    for (hair::Obstacle front : fronts) {
      Description description = alone(free_particle({0, 9, 0}, {0.02, 0, 0}), method, 1e-3);
      front.velocity = velocity;
      description.obstacles = {front};
      Simulation simulation(std::move(description));
      ASSERT_FALSE(simulation.advance(100));
      // 100 sums of numbers below 1.
      EXPECT_LE((particle(simulation, 1) - Vector3d(0.3, 0, 0)).norm(), 100 * 0x1p-52) << name_of(method);
      EXPECT_LE((simulation.state(0).v.tail<3>() - velocity).norm(), 4 * 0x1p-52) << name_of(method);

      // The tip moves on without the obstacle.
      simulation.set_obstacle_velocity(0, Vector3d::Zero());
      ASSERT_FALSE(simulation.advance(100));
      EXPECT_LE((particle(simulation, 1) - Vector3d(0.6, 0, 0)).norm(), 200 * 0x1p-52) << name_of(method);
      EXPECT_NEAR(surface_at(simulation.obstacles()[0], particle(simulation, 1)).distance, 0.3,
                  200 * 0x1p-52);
    }
}

// --- Friction ---

// A slope of tangent 1/2, and its direction downhill.
const Vector3d kSlopeNormal = Vector3d(1, 0, 2) / std::sqrt(5), kDownhill = Vector3d(2, 0, -1) / std::sqrt(5);

Description on_slope(StrandStart start, Method method, double friction) {
  Description description = alone(std::move(start), method, 1.0 / 240);
  description.gravity = kG * kDown;
  description.obstacles = {{hair::Plane{Vector3d::Zero(), kSlopeNormal}, friction}};
  return description;
}

// A hair across the slope that starts at rest stays at its place if tan < mu. Each step pushes it out by some
// depth along the normal and takes back its downhill motion, tan depth. A step leaves rounding errors, of
// numbers below 1; a particle within rounding of the surface may fall for a step, g h^2, until it is pushed
// out.
TEST(SimulationCollisions, WithinTheConeOfFrictionHairStaysWhereItIs) {
  const int steps = 240;
  for (const double downhill : {-0.4, 0.4})
    for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
      StrandStart start = straight_hair(10, 0.1, Vector3d::UnitY());
      start.state.x += (downhill * kDownhill).replicate(11, 1);
      Simulation simulation(on_slope(start, method, 0.55));
      ASSERT_FALSE(simulation.advance(steps));
      EXPECT_GT(simulation.work().contacts, steps);
      EXPECT_LE((simulation.state(0).x - start.state.x).cwiseAbs().maxCoeff(), steps * 4 * 0x1p-53)
          << name_of(method);
    }
  for (const double downhill : {-0.4, 0.4})
    for (Method method : methods_that_stretch()) {
      const StrandStart start = free_particle({0, 1, 0}, downhill * kDownhill);
      Simulation simulation(on_slope(start, method, 0.55));
      ASSERT_FALSE(simulation.advance(steps));
      EXPECT_LE((simulation.state(0).x - start.state.x).norm(), steps * 4 * 0x1p-53) << name_of(method);
    }
}

// --- H6 ---

// A hair hits a slope and lies on it. Pushed out by d = h v, a tip on the surface loses the velocity v; each
// round of corrections leaves the same part of v as of d. It ends with d at most kDeepEnough, 1e-7 m, and so
// v at most 1e-7 / h.
TEST(SimulationCollisions, WithH6VelocitiesInContactStretchNothing) {
  const double h = 1.0 / 240;
  StrandStart start = straight_hair(1, 0.1, Vector3d::UnitX());
  Description description = alone(start, Method::predictor_corrector, h);
  description.gravity = kG * kDown;
  description.obstacles = {{hair::Plane{Vector3d(0.1, 0, 0), Vector3d(1, 0, 2) / std::sqrt(5)}, 0}};
  Simulation simulation(std::move(description));
  double worst = 0;
  for (int step = 0; step < 240; ++step) {
    ASSERT_FALSE(simulation.step());
    const auto& [x, v] = simulation.state(0);
    worst = std::max(worst, std::abs(v.tail<3>().dot((x.tail<3>() - x.head<3>()).normalized())));
  }
  EXPECT_LE(worst, 1e-7 / h);
}

// --- Breaking ---

TEST(SimulationCollisions, HairThatAnObstacleFlingsAwayBreaksInTheCollision) {
  for (Method method : {Method::symplectic_euler, Method::implicit_euler, Method::predictor_corrector}) {
    Description description = alone(straight_hair(2, 0.1), method, 1e-6);
    description.strands[0].state.x += Vector3d(1e-3, 0, 0).replicate(3, 1);
    description.obstacles = {{hair::Plane{Vector3d::Zero(), Vector3d::UnitX()}}};
    Simulation simulation(std::move(description));
    ASSERT_FALSE(simulation.advance(3)) << name_of(method);
    simulation.set_obstacle_velocity(0, Vector3d(4 * hair::kFastest, 0, 0));
    const auto blow_up = simulation.step();
    ASSERT_TRUE(blow_up) << name_of(method);
    EXPECT_EQ(blow_up->step, 4);
    EXPECT_EQ(blow_up->stage, hair::Stage::collision) << name_of(method);
  }
}

}  // namespace
}  // namespace reference_tests
