// STAFF ONLY. Scenes that run, with the reference.
#include "hair/scene/scene_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/simulation/simulation.h"
#include "hair/strand/measures.h"
#include "solver/test_allocations.h"

namespace reference_tests {
namespace {

using Eigen::Vector3d;
using hair::SceneRun, hair::Scene;

Scene scene_of(const std::string& parts, const std::string& more = "") {
  return hair::parse_scene(
      R"({"shows": "a test", "frames": 10, "frames_per_second": 60, "steps_per_frame": 4, )" + more + parts +
          "}",
      "test");
}

const char* const kHair = R"("hair": [{"segments": 4, "length": 0.08, "clamped": false,
  "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}, {"position": [0, 1, 0]}]}}])";
const char* const kBall =
    R"("toys": [{"particles": [{"position": [0, 0, 0], "mass": 2, "velocity": [1, 0, 3]}]}])";

const char* const kRiders = R"(
  "hair": [{"segments": 4, "length": 0.08, "roots": {"list": [{"position": [0.1, 0, 0]}, {"position": [0, 0.1, 0]}]},
            "shape": {"wavy": {"amplitude": 0.001, "wavelength": 0.08}}, "moves_with": "head"}],
  "obstacles": [{"sphere": {"centre": [0, 0, 0.3], "radius": 0.1}, "moves_with": "head"},
                {"plane": {"point": [0, 0, -5], "normal": [0, 0, 1]}, "moves_with": "lift"}],
  "motions": [
    {"name": "head", "keys": [{"time": 0.02, "position": [0, 0, 0.1], "axis": [0, 0, 1], "degrees": 10},
                              {"time": 0.1, "position": [0.2, 0, 0.1], "axis": [0, 0, 1], "degrees": 100}]},
    {"name": "lift", "keys": [{"time": 0}, {"time": 0.1, "position": [0, 0, 1]}]}])";

TEST(SceneRun, HairMovesAsItsSimulationDoes) {
  const Scene scene = scene_of(kHair);
  SceneRun scene_run(scene);
  hair::Simulation simulation(scene.hair);
  for (int k = 0; k < 3; ++k) {
    ASSERT_FALSE(scene_run.advance());
    simulation.advance(4);
  }
  EXPECT_EQ(scene_run.frame(), 3);
  EXPECT_EQ(scene_run.time(), 0.05);
  EXPECT_EQ(scene_run.strands(), (std::vector<int>{5, 5}));
  EXPECT_EQ(scene_run.state().x.head(15), simulation.state(0).x);
  EXPECT_EQ(scene_run.state().v.tail(15), simulation.state(1).v);
  EXPECT_EQ(scene_run.work().solver_steps, simulation.work().solver_steps);
}

// As in a study with several step sizes: nothing of the previous run remains.
TEST(SceneRun, RestartedItMovesAsOneMadeAnew) {
  const std::string toy =
      R"("toys": [{"particles": [{"position": [0, 0, 0], "mass": 1, "pinned": true, "velocity": [0, 1, 0]},
    {"position": [0.1, 0, 0], "mass": 1}], "rods": [{"between": [0, 1]}]}])";
  Scene scene = scene_of(std::string(kRiders) + ", " + toy);
  SceneRun again(scene);
  for (int k = 0; k < 7; ++k) ASSERT_FALSE(again.advance());
  for (const int steps : {3, 8}) {
    scene.steps_per_frame = steps;
    scene.hair.step = 1 / (scene.frames_per_second * steps);
    again.restart(scene);
    EXPECT_EQ(again.frame(), 0);
    EXPECT_EQ(again.work().strand_steps, 0);
    EXPECT_EQ(again.steps(), 0);
    SceneRun fresh(scene);
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(again.state().x, fresh.state().x) << "frame " << k << " in steps of " << steps;
      EXPECT_EQ(again.state().v, fresh.state().v) << "frame " << k << " in steps of " << steps;
      EXPECT_EQ(again.measure(again.state()).energy(), fresh.measure(fresh.state()).energy());
      EXPECT_EQ(again.work().solver_steps, fresh.work().solver_steps);
      ASSERT_FALSE(again.advance());
      ASSERT_FALSE(fresh.advance());
      EXPECT_EQ(again.steps(), (k + 1) * steps);
    }
  }
  // Also after a blow-up.
  scene.hair.method = hair::Method::forward_euler;
  scene.hair.step = 0.01;
  scene.steps_per_frame = 1000;
  SceneRun broken(scene);
  ASSERT_TRUE(broken.advance());
  const long steps = broken.steps();
  EXPECT_EQ(broken.work().strand_steps, steps * static_cast<long>(scene.hair.strands.size()));
  EXPECT_LT(steps, scene.steps_per_frame);
  broken.advance();
  EXPECT_EQ(broken.steps(), steps) << "after the step that broke there are no more";
  scene.hair.step = 1e-7;
  scene.steps_per_frame = 2;
  broken.restart(scene);
  EXPECT_FALSE(broken.advance());
}

TEST(SceneRun, AToyFliesAsTheParabolaSays) {
  SceneRun scene_run(scene_of(kBall));
  for (int k = 0; k < 6; ++k) ASSERT_FALSE(scene_run.advance());
  // Runge and Kutta's method is exact for a parabola, except for rounding.
  const double t = 0.1;
  EXPECT_NEAR((scene_run.state().x - Vector3d(t, 0, 3 * t - 9.81 / 2 * t * t)).norm(), 0, 1e-14);
  EXPECT_NEAR(scene_run.measure(scene_run.state()).energy(), 10, 1e-13);
}

TEST(SceneRun, StrandsComeBeforeToysAndAllAreMeasuredTogether) {
  const std::string both = std::string(kHair) + ", " + kBall;
  SceneRun hair(scene_of(kHair)), ball(scene_of(kBall)), all(scene_of(both));
  for (int k = 0; k < 2; ++k)
    for (SceneRun* scene_run : {&hair, &ball, &all}) ASSERT_FALSE(scene_run->advance());
  EXPECT_EQ(all.state().x.head(30), hair.state().x);
  EXPECT_EQ(all.state().x.tail(3), ball.state().x);
  const auto one = hair.measure(hair.state()), two = ball.measure(ball.state()),
             sum = all.measure(all.state());
  EXPECT_DOUBLE_EQ(sum.kinetic, one.kinetic + two.kinetic);
  EXPECT_DOUBLE_EQ(sum.potential, one.potential + two.potential);
  EXPECT_NEAR((sum.momentum - one.momentum - two.momentum).norm(), 0, 1e-15);
  EXPECT_EQ(sum.stretch, one.stretch);
  // Any strand may have the largest stretch.
  for (const int strand : {0, 1}) {
    particles::State torn = hair.state();
    torn.x.segment<3>(15 * strand + 12) += Vector3d(0, 0, 10);
    EXPECT_GT(hair.measure(torn).stretch, 1) << strand;
  }
  // The sum of m x times v is about the origin, and not about a root.
  const Scene scene = scene_of(kHair);
  particles::State state = hair.state();
  state.v.setOnes();
  Vector3d turning = Vector3d::Zero();
  for (Eigen::Index k = 0; k < 10; ++k)
    turning += scene.hair.strands[static_cast<std::size_t>(k / 5)].strand.mass[k % 5] *
               Vector3d(state.x.segment<3>(3 * k)).cross(Vector3d::Ones());
  EXPECT_NEAR((hair.measure(state).angular_momentum - turning).norm(), 0, 1e-12 * turning.norm());
  EXPECT_NEAR((two.angular_momentum - 2 * Vector3d(ball.state().x).cross(Vector3d(ball.state().v))).norm(), 0,
              1e-14);
}

TEST(SceneRun, StretchIsTheLargestOfAnySpringOrRod) {
  const Scene scene = scene_of(
      R"("toys": [{"particles": [{"position": [0, 0, 0], "mass": 1}, {"position": [1, 0, 0], "mass": 1},
    {"position": [1, 2, 0], "mass": 1}], "springs": [{"between": [0, 1], "stiffness": 1, "rest_length": 0.8}],
    "rods": [{"between": [1, 2], "length": 1.5}]}])");
  const SceneRun scene_run(scene);
  particles::State state = scene_run.state();
  EXPECT_DOUBLE_EQ(scene_run.measure(state).stretch, 2 / 1.5 - 1);
  state.x[7] = NAN;
  EXPECT_TRUE(std::isnan(scene_run.measure(state).stretch));
}

TEST(Motion, SpeedsUpAndSlowsDownBetweenKeysAndRestsOutsideOfThem) {
  const hair::Motion motion = scene_of(kRiders).riders[1].motion;  // 1 m in 0.1 s
  const auto height = [&](double time) { return motion.at(time).position.z(); };
  EXPECT_EQ(height(-1), 0);
  EXPECT_NEAR(height(0.025), 5.0 / 32, 1e-15);
  EXPECT_NEAR(height(0.05), 0.5, 1e-15);
  EXPECT_NEAR(height(0.075), 27.0 / 32, 1e-15);
  EXPECT_EQ(height(0.1), 1);
  EXPECT_EQ(height(7), 1);
  // The motion covers 3 s^2 of the way at first, and the same part is missing at the end.
  EXPECT_NEAR(height(1e-4), 3e-6, 3e-9);
  EXPECT_NEAR(1 - height(0.1 - 1e-4), 3e-6, 3e-9);
}

// Moving roots continue from the new scene's positions and frames.
TEST(SceneRun, RestartsWithRootsElsewhere) {
  const Scene scene = scene_of(kRiders, R"("method": "implicit_euler", )");
  Scene moved = scene;
  for (hair::StrandStart& start : moved.hair.strands)
    for (Eigen::Index i = 0; i < start.state.x.size(); i += 3)
      start.state.x.segment<3>(i) += Eigen::Vector3d(0.25, -0.5, 0.125);
  SceneRun again(scene), fresh(moved);
  again.advance();
  again.restart(moved);
  for (int k = 0; k < 3; ++k) {
    again.advance();
    fresh.advance();
    EXPECT_EQ(again.state().x, fresh.state().x) << "frame " << k;
  }
}

TEST(SceneRun, RidersAreWhereTheirMotionAndTheHandSayAfterEveryFrame) {
  const Scene scene = scene_of(kRiders, R"("method": "implicit_euler", )");
  for (const bool led : {false, true}) {
    SceneRun scene_run(scene);
    for (int k = 1; k <= scene.frames; ++k) {
      hair::Way hand;
      if (led)
        hand = {
            Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * k, Vector3d::UnitZ())), {0, 0, 1}, {0.01 * k, 0, 1}};
      scene_run.lead(hand);
      ASSERT_FALSE(scene_run.advance());
      const hair::Motion& head = scene.riders[0].motion;
      const hair::Pose now = head.at(k / 60.0), first = head.keys[0].pose;
      const auto way = [&](const Vector3d& x) -> Vector3d {
        return hand(now.rotation * first.rotation.conjugate() * (x - first.position) + now.position);
      };
      const particles::State state = scene_run.state();
      // A step adds to the root's position: the error is always the rounding of one step.
      EXPECT_NEAR((state.x.segment<3>(0) - way({0.1, 0, 0})).norm(), 0, 1e-15);
      EXPECT_NEAR((state.x.segment<3>(15) - way({0, 0.1, 0})).norm(), 0, 1e-15);
      EXPECT_NEAR((std::get<hair::Sphere>(scene_run.obstacles()[0].shape).centre - way({0, 0, 0.3})).norm(),
                  0, 1e-15);
      EXPECT_NEAR(std::get<hair::Plane>(scene_run.obstacles()[1].shape).point.z(),
                  -5 + scene.riders[1].motion.at(k / 60.0).position.z(), 1e-14);
    }
    // The motion has turned the root by 90 degrees.
    if (!led) {
      EXPECT_NEAR((scene_run.state().x.head<3>() - Vector3d(0.2, 0.1, 0)).norm(), 0, 1e-15);
    }
  }
}

// A root that moves with a bust stays at its place on it, and the bust has the pose of its motion and of the
// hand.
TEST(SceneRun, ABustMovesAndTurnsWithTheRootsOnIt) {
  const Scene scene = scene_of(R"("hair": [{"moves_with": "head",
      "groom": {"style": "long-smooth", "strands": 5, "points": 8, "at": [0.1, 0.2, 0.3]}}],
    "obstacles": [{"bust": {"at": [0.1, 0.2, 0.3]}, "friction": 0.3, "moves_with": "head"}],
    "motions": [{"name": "head", "keys": [{"time": 0, "position": [0, 0, 0.3]},
      {"time": 0.04, "position": [0.2, 0, 0.3], "axis": [1, 1, 0], "degrees": 60}]}])",
                               R"("method": "implicit_euler", )");
  SceneRun scene_run(scene);
  for (int k = 1; k <= scene.frames; ++k) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.05 * k, Vector3d::UnitZ()));
    const hair::Way hand{turn, {0, 0, 0}, {0.01 * k, 0, 0}};
    scene_run.lead(hand);
    ASSERT_FALSE(scene_run.advance());
    const hair::Obstacle& bust = scene_run.obstacles()[0];
    const auto& placed = std::get<hair::PlacedSolid>(bust.shape);
    const hair::Way way = hand * way_at(scene.riders[0].motion, k / 60.0);
    // Each step turns it by its own exponential: rounding of some steps.
    EXPECT_LE((placed.at - way({0.1, 0.2, 0.3})).norm(), 1e-14);
    EXPECT_LE(placed.rotation.angularDistance(way.rotation), 1e-12);
    const particles::State state = scene_run.state();
    // Near 0 the distance is right to rounding: points on the bust stay on it.
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(surface_at(bust, state.x.segment<3>(24 * i)).distance, 0, 1e-12) << i;
  }
}

TEST(SceneRun, WhatBreaksIsNamedAndStaysWhereItIs) {
  // Forward Euler far beyond its limit.
  Scene scene = scene_of(R"("toys": [)" + std::string(kBall).substr(9, std::string(kBall).size() - 10) +
                         R"(, {"method": "forward_euler", "particles": [{"position": [0, 0, 0], "mass": 1e-6},
                           {"position": [1, 0, 0], "mass": 1e-6}],
                           "springs": [{"between": [0, 1], "stiffness": 1e6, "rest_length": 0.5}]}])");
  SceneRun scene_run(scene);
  const auto trouble = scene_run.advance();
  ASSERT_TRUE(trouble);
  EXPECT_EQ(*trouble, "toy 1, step 1: integration");
  EXPECT_EQ(scene_run.frame(), 0);
  EXPECT_EQ(scene_run.advance(), trouble);
  EXPECT_EQ(scene_run.frame(), 0);

  scene = scene_of(kHair, R"("method": "forward_euler", )");
  SceneRun strand(scene);
  std::optional<std::string> said;
  for (int k = 0; k < 10 && !said; ++k) said = strand.advance();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->rfind("strand ", 0), 0U) << *said;
  EXPECT_NE(said->find(": integration"), std::string::npos) << *said;
}

TEST(SceneRun, ClothKeepsItsCornersAndSags) {
  const Scene scene = scene_of(
      R"("toys": [{"method": "implicit_euler", "cloth": {"rows": 5, "columns": 6, "corner": [0, 0, 0], "across": [0.5, 0, 0],
         "down": [0, 0.4, 0], "area_density": 0.1, "stretch": 100, "shear": 10, "bend": 1, "damping": 0.01,
         "pinned": ["top_left", "bottom_right"]}}])");
  const hair::Toy& toy = scene.toys[0];
  EXPECT_NEAR(toy.particles.mass.sum(), 0.1 * 0.5 * 0.4, 1e-15);
  // Threads 5 x 5 + 4 x 6, diagonals 2 x 4 x 5, second neighbours 5 x 4 + 3 x 6.
  EXPECT_EQ(toy.springs.size(), 49U + 40U + 38U);
  SceneRun scene_run(scene);
  const Eigen::VectorXd before = scene_run.state().x;
  for (int k = 0; k < 10; ++k) ASSERT_FALSE(scene_run.advance());
  const Eigen::VectorXd after = scene_run.state().x;
  EXPECT_EQ(after.head<3>(), before.head<3>());
  EXPECT_EQ(after.tail<3>(), before.tail<3>());
  EXPECT_LT(after[3 * 5 + 2], -0.01);
}

TEST(SceneRun, AStepAllocatesWhatConjGradDoes) {
  const auto counted = [](const Scene& scene) {
    SceneRun scene_run(scene);
    scene_run.advance();
    const long before = allocations();
    scene_run.advance();
    return allocations() - before;
  };
  Scene scene = scene_of(kBall);
  EXPECT_EQ(counted(scene), 0);
  scene = scene_of(std::string(kRiders), R"("method": "midpoint", "tolerance": 1e-10, )");
  scene.hair.strands[0].strand.stretch_rigidity = scene.hair.strands[1].strand.stretch_rigidity = 1e-6;
  EXPECT_EQ(counted(scene), 0);
}

// The second strand's tip is a centimetre away from the link's position: k d^2 / 2, and the same bends and
// weights with any k. A toy ball comes after all strands.
TEST(SceneRun, MeasuresTheEnergyOfLinks) {
  const auto potential = [](const std::string& stiffness) {
    const Scene scene = scene_of(R"("method": "implicit_euler", "hair": [{"segments": 4, "length": 0.08,
      "roots": {"list": [{"position": [0, 0, 0]}, {"position": [0.02, 0, 0]}]}}],
      "links": {"stiffness": )" + stiffness +
                                 "}, " + kBall);
    const SceneRun scene_run(scene);
    EXPECT_NE(scene_run.mesh_record(), nullptr);
    particles::State state = scene_run.state();
    state.x[3 * 9 + 1] += 0.01;
    return scene_run.measure(state).potential;
  };
  const double without = potential("0");
  EXPECT_NEAR(potential("2") - without, 2 * 0.01 * 0.01 / 2, 1e-12);
  EXPECT_EQ(SceneRun(scene_of(kHair)).mesh_record(), nullptr);
}

TEST(SceneRun, WhatIsOutOfBoundsThrows) {
  Scene scene = scene_of(kBall);
  scene.toys[0].particles.mass[0] = -1;
  EXPECT_THROW(SceneRun{scene}, std::invalid_argument);
  scene = scene_of(kBall);
  scene.toys[0].springs.push_back({0, 7, 1, 1, 0});
  EXPECT_THROW(SceneRun{scene}, std::invalid_argument);
  scene = scene_of(kBall);
  scene.steps_per_frame = 0;
  EXPECT_THROW(SceneRun{scene}, std::invalid_argument);
  scene = scene_of(kRiders);
  scene.riders[0].strands.push_back(2);
  EXPECT_THROW(SceneRun{scene}, std::invalid_argument);
  scene = scene_of(kRiders);
  scene.riders[0].motion.keys.clear();
  EXPECT_THROW(SceneRun{scene}, std::invalid_argument);
}

}  // namespace
}  // namespace reference_tests
