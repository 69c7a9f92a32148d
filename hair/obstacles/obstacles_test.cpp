#include "hair/obstacles/obstacles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "hair/obstacles/meeting.h"
#include "hair/obstacles/test_placed_ball.h"
#include "solver/test_numbers.h"

namespace hair {
namespace {

using particles::Particles;
using particles::State;

constexpr double kG = reference_tests::kGravity;

Particles one_particle() {
  return {Eigen::VectorXd::Constant(1, 0.3), {0}};
}

State state_of(const Vector3d& x, const Vector3d& v) {
  return {x, v};
}

Obstacle slope(double degrees, double friction) {
  const double angle = degrees * std::numbers::pi / 180;
  return {Plane{Vector3d(1, 2, 3), Vector3d(std::sin(angle), 0, std::cos(angle))}, friction};
}

// A particle that falls and collides for `steps` steps of h, each a step of symplectic Euler.
State slide(const Obstacle& obstacle, State state, double h, int steps) {
  const Particles particle = one_particle();
  for (int step = 0; step < steps; ++step) {
    const Eigen::VectorXd before = state.x;
    state.v[2] -= h * kG;
    state.x += h * state.v;
    collide({obstacle}, particle, h, before, state);
  }
  return state;
}

TEST(Obstacles, NothingIsInsideAfterwards) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  const std::vector<Obstacle> obstacles = {{Plane{Vector3d(0, 0, -0.5), Vector3d(0, 0, 1)}, 0.4},
                                           {Sphere{Vector3d(0.2, 0, -0.4), 0.5}, 0.1, vector()},
                                           {Capsule{Vector3d(-1, 0, 0), Vector3d(1, 0.5, 0.2), 0.2}, 2}};
  const int n = 1000;
  Particles particles{Eigen::VectorXd::Ones(n), std::vector<char>(n, 0)};
  State state{Eigen::VectorXd(3 * n), Eigen::VectorXd(3 * n)};
  Eigen::VectorXd before(3 * n);
  for (int i = 0; i < n; ++i) {
    state.x.segment<3>(3 * i) = vector();
    state.v.segment<3>(3 * i) = 10 * vector();
    before.segment<3>(3 * i) = vector();
  }
  const CollisionReport report = collide(obstacles, particles, 0.01, before, state);
  EXPECT_GT(report.contacts, n / 4);
  // Two surfaces meet at an angle: each pass removes at least the part 1 - cos^2 of the remaining depth. 1e-9
  // m is far below a hair's radius.
  EXPECT_LE(report.penetration, 1e-9);
  for (int i = 0; i < n; ++i)
    for (const Obstacle& obstacle : obstacles)
      EXPECT_GE(surface_at(obstacle, state.x.segment<3>(3 * i)).distance,
                -std::max(report.penetration, 4e-14));
}

TEST(Obstacles, WhatIsOutsideOrPinnedStaysAsItIs) {
  Particles particles{Eigen::VectorXd::Ones(2), {0, 1}};
  State state{Eigen::VectorXd(6), Eigen::VectorXd::Constant(6, -1.25)};
  state.x << 0, 0, 1.5, 0.1, 0, 0;  // the second is deep inside, but pinned
  const State was = state;
  const CollisionReport report = collide({{Sphere{Vector3d::Zero(), 1}, 0.5}}, particles, 0.1, was.x, state);
  EXPECT_EQ(report.contacts, 0);
  EXPECT_EQ(state.x, was.x);
  EXPECT_EQ(state.v, was.v);
}

// Velocities before and after a blow on the ground; at 0.5, friction is half of the blow.
TEST(Obstacles, FrictionIsMuTimesTheBlowAlongTheSurfaceAndWhatLeavesIsNotHeldBack) {
  const struct {
    double friction;
    Vector3d before, v, left;
  } rows[] = {{0, {-0.3, -0.4, 0.4}, {3, 4, -5}, {3, 4, 0}},
              {0.5, {0, 0, 0.4}, {3, 4, -5}, {1.5, 2, 0}},
              {0.5, {0, 0, -0.6}, {3, 4, 5}, {3, 4, 5}}};
  for (const auto& [friction, before, v, left] : rows) {
    State state = state_of({0, 0, -0.1}, v);
    collide({{Plane{Vector3d::Zero(), Vector3d::UnitZ()}, friction}}, one_particle(), 0.1, before, state);
    EXPECT_LE((state.v - left).norm(), friction * v[2] < 0 ? 1e-15 : 0) << friction << ", " << v.transpose();
    if (friction == 0) {
      EXPECT_EQ(state.x, Vector3d::Zero());
    }
  }
}

// --- Along the way ---

// The particle moves from `from` to `to` in a step, and is stopped by the plane that touches the obstacle at
// `meets`.
void expect_stopped(const Obstacle& obstacle, const Vector3d& from, const Vector3d& to,
                    const Vector3d& meets) {
  constexpr double h = 0.01;
  State state = state_of(to, (to - from) / h);
  const CollisionReport report = collide({obstacle}, one_particle(), h, from, state);
  const Vector3d n = surface_at(obstacle, meets).normal;
  const double depth = n.dot(meets - to);
  EXPECT_GT(depth, 0);
  EXPECT_EQ(report.contacts, 1);
  EXPECT_LE((state.x - (to + depth * n)).norm(), 1e-12);
  const Vector3d u = (to - from) / h - obstacle.velocity;
  EXPECT_LE((state.v - obstacle.velocity - (u - n.dot(u) * n)).norm(), 1e-10);
  EXPECT_GE(surface_at(obstacle, state.x).distance, -1e-12);
}

TEST(Obstacles, NobodyGoesThroughOneInAStep) {
  const Obstacle ball{Sphere{Vector3d(1, 2, 3), 0.5}};
  expect_stopped(ball, {1, 2, 5}, {1, 2, 0}, {1, 2, 3.5});
  expect_stopped(ball, {0.7, 2, 5}, {0.7, 2, 0}, {0.7, 2, 3.4});
  expect_stopped(ball, {0.7, 2, 5}, {0.7, 2, 2.7}, {0.7, 2, 3.4});  // inside, nearer to the other side
  const Obstacle limb{Capsule{Vector3d(-1, 0, 0), Vector3d(1, 0, 0), 0.2}};
  expect_stopped(limb, {0.5, 0, 2}, {0.3, 0, -2}, {0.41, 0, 0.2});
  expect_stopped(limb, {2, 0, 0.1}, {-2, 0, 0.1}, {1 + std::sqrt(0.03), 0, 0.1});
  expect_stopped(limb, {1.1, 0, 1}, {1.1, 0, -1}, {1.1, 0, std::sqrt(0.03)});
  expect_stopped({Capsule{Vector3d::Zero(), Vector3d::Zero(), 0.2}}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0.2});
}

// The way relative to the obstacle counts; the obstacle is at its position of the step's end.
TEST(Obstacles, NobodyIsOvertakenByOne) {
  const Obstacle ball{Sphere{Vector3d(0, 0, 3), 0.5}, 0, Vector3d(0, 0, 600)};  // 6 m in the step
  State state = state_of({0, 0, 0}, Vector3d::Zero());
  const CollisionReport report = collide({ball}, one_particle(), 0.01, Vector3d::Zero(), state);
  EXPECT_EQ(report.contacts, 1);
  EXPECT_LE((state.x - Vector3d(0, 0, 3.5)).norm(), 1e-12);
  EXPECT_LE((state.v - ball.velocity).norm(), 1e-10);
  // Its work is the impulse, m v, times its velocity v.
  const double m = one_particle().mass[0];
  EXPECT_NEAR(report.work, m * 600 * 600, 1e-9 * m * 600 * 600);
  EXPECT_LE((report.impulse - m * ball.velocity).norm(), 1e-10);
}

TEST(Obstacles, WhoPassesBesideOneOrBeginsInsideIsAsBefore) {
  const Obstacle ball{Sphere{Vector3d::Zero(), 0.5}};
  const auto after = [&](const Vector3d& from, const Vector3d& to) {
    State state = state_of(to, Vector3d::Zero());
    collide({ball}, one_particle(), 0.01, from, state);
    return Vector3d(state.x);
  };
  EXPECT_EQ(after({0.501, 0, 2}, {0.501, 0, -2}), Vector3d(0.501, 0, -2));  // beside it
  EXPECT_EQ(after({0, 0, 2}, {0, 0, 0.6}), Vector3d(0, 0, 0.6));            // before it
  EXPECT_EQ(after({0, 0, 0.6}, {0, 0, 2}), Vector3d(0, 0, 2));              // away from it
  EXPECT_EQ(after({0, 0, 0.1}, {0, 0, -2}), Vector3d(0, 0, -2));            // from inside
  EXPECT_LE((after({0, 0, 0.1}, {0, 0, -0.1}) - Vector3d(0, 0, -0.5)).norm(), 1e-15);
  // Slides from the surface to the surface, 30 degrees further.
  const Vector3d slid(0.25 + 1e-9, 0, std::sqrt(0.1875));
  EXPECT_EQ(after({0, 0, 0.5}, slid), slid);
}

// On a slope of angle a a particle rests if and only if tan(a) <= mu, the edge of the friction cone.
TEST(Obstacles, AParticleRestsInsideTheFrictionConeAndSlidesOutside) {
  for (const double degrees : {5.0, 20.0, 45.0, 70.0}) {
    const double mu = std::tan(degrees * std::numbers::pi / 180), h = 1e-3;
    const State start = state_of({1, 2, 3}, Vector3d::Zero());
    const State rests = slide(slope(degrees, 1.001 * mu), start, h, 2000);
    // Rounding of 2000 steps; without friction on positions it would creep by 2000 h^2 g sin = 2 cm.
    EXPECT_LE((rests.x - start.x).norm(), 2000 * 1e-15) << degrees;
    EXPECT_LE(rests.v.norm(), 1e-15) << degrees;

    const State slides = slide(slope(degrees, 0.9 * mu), start, h, 2000);
    EXPECT_GT((slides.x - start.x).norm(), 0.05 * kG * std::sin(degrees * std::numbers::pi / 180)) << degrees;
  }
}

TEST(Obstacles, SlidingDownhillHasTheAccelerationOfGravityLessFriction) {
  const double angle = 30 * std::numbers::pi / 180, mu = 0.3, h = 1e-3;
  const int steps = 1000;
  const State start = state_of({1, 2, 3}, Vector3d::Zero());
  const State end = slide(slope(30, mu), start, h, steps);
  const double acceleration = kG * (std::sin(angle) - mu * std::cos(angle)), t = h * steps;
  // Symplectic Euler of a constant acceleration: h sum of (1 + ... + n) h a = a t (t + h) / 2.
  EXPECT_NEAR(end.v.norm(), acceleration * t, 1e-11);
  EXPECT_NEAR((end.x - start.x).norm(), acceleration * t * (t + h) / 2, 1e-11);
}

TEST(Obstacles, OnTheGroundAParticleSlowsDownByMuGAndStops) {
  const double mu = 0.25, h = 1e-3, v0 = 2;
  const Obstacle ground{Plane{Vector3d::Zero(), Vector3d::UnitZ()}, mu};
  const State start = state_of(Vector3d::Zero(), {v0, 0, 0});
  EXPECT_NEAR(slide(ground, start, h, 400).v[0], v0 - mu * kG * 0.4, 1e-12);
  const State end = slide(ground, start, h, 2000);
  EXPECT_EQ(end.v.norm(), 0);
  EXPECT_NEAR(end.x[0], v0 * v0 / (2 * mu * kG), v0 * h);  // v^2 / 2a, to one step's way
}

TEST(Obstacles, WhatLiesOnAMovingSurfaceIsTakenAlong) {
  const double h = 1e-3;
  const Vector3d belt(0.5, 0, 0);
  const Obstacle ground{Plane{Vector3d::Zero(), Vector3d::UnitZ()}, 0.4, belt};
  const State end = slide(ground, state_of(Vector3d::Zero(), Vector3d::Zero()), h, 1000);
  EXPECT_LE((end.v - belt).norm(), 1e-14);
  const State on = slide(ground, end, h, 1000);
  EXPECT_LE((on.x - end.x - belt).norm(), 1e-12);
}

TEST(Obstacles, AMovingObstaclePushesWithItsVelocity) {
  State state = state_of({0.9, 0, 0}, Vector3d::Zero());
  Obstacle head{Sphere{Vector3d(-0.2, 0, 0), 1}, 0, Vector3d(2, 0, 0)};
  move_obstacle(head, 0.1);
  collide({head}, one_particle(), 0.1, state.x, state);
  EXPECT_LE((state.x - Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_LE((state.v - Vector3d(2, 0, 0)).norm(), 1e-15);
}

TEST(Obstacles, ACapsuleIsASphereAtItsEndsAndACylinderBetween) {
  const Vector3d a(0, 0, 0), b(0, 0, 2);
  const Obstacle capsule{Capsule{a, b, 0.5}};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-2, 4);
  for (int k = 0; k < 200; ++k) {
    const Vector3d point(uniform(random), uniform(random), uniform(random));
    const Surface surface = surface_at(capsule, point);
    const Surface expected = point[2] <= 0   ? surface_at({Sphere{a, 0.5}}, point)
                             : point[2] >= 2 ? surface_at({Sphere{b, 0.5}}, point)
                                             : Surface{std::hypot(point[0], point[1]) - 0.5,
                                                       Vector3d(point[0], point[1], 0).normalized()};
    EXPECT_NEAR(surface.distance, expected.distance, 1e-15 * 8);
    EXPECT_LE((surface.normal - expected.normal).norm(), 1e-15 * 8);
  }
  const Obstacle ball{Capsule{a, a, 0.5}};
  EXPECT_EQ(surface_at(ball, Vector3d(3, 0, 4)).distance, 4.5);
}

TEST(Obstacles, TheMiddleHasANormalToo) {
  for (const Obstacle& obstacle :
       {Obstacle{Sphere{Vector3d(1, 1, 1), 2}}, Obstacle{Capsule{{1, 1, 0}, {1, 1, 2}, 2}},
        Obstacle{Capsule{{1, 1, 1}, {1, 1, 1}, 2}}}) {
    const Surface surface = surface_at(obstacle, Vector3d(1, 1, 1));
    EXPECT_EQ(surface.distance, -2);
    EXPECT_NEAR(surface.normal.norm(), 1, 1e-15);
  }
  EXPECT_NEAR(surface_at({Capsule{{1, 1, 0}, {1, 1, 2}, 2}}, Vector3d(1, 1, 1)).normal[2], 0, 1e-15);
}

TEST(Obstacles, WithoutRoomBetweenThemTheDepthIsReportedAndItEnds) {
  const std::vector<Obstacle> press = {{Plane{Vector3d(0, 0, 0.1), Vector3d::UnitZ()}},
                                       {Plane{Vector3d(0, 0, -0.1), -Vector3d::UnitZ()}}};
  State state = state_of(Vector3d::Zero(), Vector3d::Zero());
  const CollisionReport report = collide(press, one_particle(), 0.1, state.x, state);
  EXPECT_EQ(report.contacts, 1);
  EXPECT_NEAR(report.penetration, 0.2, 1e-15);
}

TEST(Obstacles, BadOnesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(check_obstacle({Plane{Vector3d::Zero(), Vector3d::UnitX()}, 0.5}));
  EXPECT_THROW(check_obstacle({Plane{Vector3d::Zero(), Vector3d(0, 0, 2)}}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({Plane{Vector3d(nan, 0, 0), Vector3d::UnitX()}}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({Sphere{Vector3d::Zero(), 0}}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({Capsule{Vector3d::Zero(), Vector3d(nan, 0, 0), 1}}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({Capsule{Vector3d::Zero(), Vector3d::Zero(), -1}}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({Sphere{Vector3d::Zero(), 1}, -0.1}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({Sphere{Vector3d::Zero(), 1}, 0, Vector3d(0, nan, 0)}), std::invalid_argument);
}

TEST(PlacedSolid, TurnsAndMovesAndMeetsLikeTheBallThatItIs) {
  Obstacle placed{PlacedSolid{std::make_shared<BesideOrigin>(), {1, 2, 3}}};
  std::get<PlacedSolid>(placed.shape).angular_velocity = {0, 0, M_PI / 2};
  placed.velocity = {0, 0, 1};
  const Vector3d at(1.3, 2, 3);
  // The velocity of a rotation, in addition to that of the origin.
  EXPECT_NEAR((velocity_at(placed, at) - Vector3d(0, 0.3 * M_PI / 2, 1)).norm(), 0, 1e-15);
  move_obstacle(placed, 1);
  const Obstacle ball{Sphere{{1, 2.3, 4}, 0.1}};
  for (const Vector3d& point : {Vector3d(1, 2.5, 4), Vector3d(1.02, 2.31, 4.05), Vector3d(3, -2, 1)}) {
    const Surface here = surface_at(placed, point), there = surface_at(ball, point);
    EXPECT_NEAR(here.distance, there.distance, 1e-14);
    EXPECT_NEAR((here.normal - there.normal).norm(), 0, 1e-13);
  }
  // A particle that would pass through it meets it at the same point as the ball.
  const Vector3d from(0.7, 2.33, 4.01), to(1.4, 2.31, 4);
  const auto here = first_meeting(placed, from, to), there = first_meeting(ball, from, to);
  ASSERT_TRUE(here && there);
  EXPECT_NEAR((here->point - there->point).norm(), 0, 1e-11);
  EXPECT_FALSE(first_meeting(placed, from, {0.7, 2.5, 5}));
}

// Particles on all sides, inside and outside, slow and fast: pushed out, dragged along and slowed down by
// friction as by a sphere. The two differ by rounding: of the turn there and back, and of a fast particle's
// contact, to 1e-11 m.
TEST(PlacedSolid, CollidesAndDragsAlongAsTheBallThatItIs) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  const Vector3d centre(0.2, -0.1, 0.4), velocity(0.5, 0.3, -1);
  constexpr double radius = 0.3, mu = 0.4, h = 0.01;
  const int n = 500;
  const Particles particles{Eigen::VectorXd::Ones(n), std::vector<char>(n, 0)};
  Eigen::VectorXd before(3 * n);
  State ball{Eigen::VectorXd(3 * n), Eigen::VectorXd(3 * n)};
  for (int i = 0; i < n; ++i) {
    before.segment<3>(3 * i) = centre + 0.45 * vector();
    ball.v.segment<3>(3 * i) = 20 * vector();
    ball.x.segment<3>(3 * i) = before.segment<3>(3 * i) + h * ball.v.segment<3>(3 * i);
  }
  State placed = ball;
  const CollisionReport by_ball =
      collide({{Sphere{centre, radius}, mu, velocity}}, particles, h, before, ball);
  const CollisionReport by_solid =
      collide({placed_ball(centre, radius, mu, velocity)}, particles, h, before, placed);
  EXPECT_GT(by_ball.contacts, 20);
  EXPECT_EQ(by_solid.contacts, by_ball.contacts);
  EXPECT_NEAR(by_solid.work, by_ball.work, 1e-7);
  EXPECT_LE((placed.x - ball.x).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE((placed.v - ball.v).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(PlacedSolid, TheDistanceChangesItsSignAtTheSurface) {
  const Obstacle placed = placed_ball({1, 2, 3}, 0.2);
  for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0, 0.6, 0.8)})
    for (const double depth : {-0.05, -1e-6, 1e-6, 0.5}) {
      const Surface here = surface_at(placed, Vector3d(1, 2, 3) + (0.2 + depth) * way);
      EXPECT_NEAR(here.distance, depth, 1e-14);
      EXPECT_LE((here.normal - way).norm(), 1e-13);
    }
}

TEST(PlacedSolid, WithoutASolidIsRefused) {
  EXPECT_THROW(check_obstacle({PlacedSolid{}}), std::invalid_argument);
  EXPECT_THROW(check_obstacle({PlacedSolid{
                   std::make_shared<BesideOrigin>(), {0, 0, 0}, Eigen::Quaterniond(2, 0, 0, 0)}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace hair
