#include "hair/scene_drawing/scene_drawing.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "hair/obstacles/test_placed_ball.h"
#include "hair/scene_drawing/scene_bounds.h"
#include "hair/strand/make_strand.h"

namespace hair {
namespace {

constexpr double kLength = 0.3;  // m, of the strand

// A strand that starts level and hangs later, on a head that moves a metre aside.
Scene moving_head() {
  Scene scene;
  StrandStart start;
  start.strand.mass = Eigen::VectorXd::Constant(4, 1e-6);
  start.strand.rest_length = Eigen::VectorXd::Constant(3, kLength / 3);
  start.state = {Eigen::VectorXd::Zero(12), Eigen::VectorXd::Zero(12)};
  for (int i = 0; i < 4; ++i) start.state.x[3 * i] = kLength / 3 * i;
  scene.hair.strands.push_back(start);
  scene.hair.obstacles.push_back({Sphere{Vector3d(-0.1, 0, 0), 0.09}});
  Rider rider;
  rider.motion.keys.push_back({0, {}});
  rider.motion.keys.push_back({1, {Vector3d(0, 1, 0), Eigen::Quaterniond::Identity()}});
  rider.strands = {0};
  rider.obstacles = {0};
  scene.riders.push_back(rider);
  return scene;
}

Toy pendulum() {
  Toy toy;
  toy.particles = {Eigen::VectorXd::Ones(2), {1, 0}};
  toy.start = {Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  toy.start.x[3] = 0.5;
  toy.constraints.rods.push_back({0, 1, 0.5});
  return toy;
}

void expect_inside(const Bounds& bounds, const Vector3d& point) {
  EXPECT_TRUE(bounds.contains(point))
      << point.transpose() << " is not in " << bounds.min().transpose() << " to " << bounds.max().transpose();
}

Bounds bounds_of(const Toy& toy) {
  Scene scene;
  scene.frames = 30;
  scene.frames_per_second = 30;
  scene.toys = {toy};
  return scene_bounds(scene);
}

TEST(SceneBounds, HairIsInsideWhereItStartsWhereItHangsAndWhereKeysTakeIt) {
  const Bounds bounds = scene_bounds(moving_head());
  for (const double y : {0.0, 1.0}) {
    expect_inside(bounds, Vector3d(kLength, y, 0));
    expect_inside(bounds, Vector3d(0, y, -kLength));
    expect_inside(bounds, Vector3d(-kLength, y, 0));
    expect_inside(bounds, Vector3d(-0.19, y, 0.09));
  }
  EXPECT_LT(bounds.max()[0], 1.01 * kLength) << "and no larger than that";
}

TEST(SceneBounds, HairHangsAboveTheGround) {
  Scene scene = moving_head();
  scene.hair.obstacles.push_back({Plane{Vector3d(0, 0, -0.1), Vector3d(0, 0, 1)}});
  EXPECT_NEAR(scene_bounds(scene).min()[2], -0.1, 1e-12);
}

TEST(SceneBounds, APendulumIsInsideOnItsWay) {
  const Bounds bounds = bounds_of(pendulum());
  for (const Vector3d& point : {Vector3d(0.5, 0, 0), Vector3d(-0.5, 0, 0), Vector3d(0, 0, -0.5)})
    expect_inside(bounds, point);
}

// A particle on a rod below a bead can be as far from the wire as the rod is long.
TEST(SceneBounds, ABeadAndWhatHangsOnItAreInside) {
  Toy toy = pendulum();
  toy.particles.pinned = {0, 0};
  Toy bead = toy;
  bead.constraints.rods.clear();
  bead.constraints.wires.push_back({1, Vector3d(0.25, 0, 0), Vector3d(0, 1, 0), 0.25});
  expect_inside(bounds_of(bead), Vector3d(0.25, 0, 0.25));
  EXPECT_NEAR(bounds_of(bead).max()[1], 0, 1e-12);
  toy.constraints.wires.push_back({0, Vector3d(0, 0, 0.25), Vector3d(0, 1, 0), 0.25});
  expect_inside(bounds_of(toy), Vector3d(0.75, 0, 0.25));
}

// Two rods that start folded hang with the length of both.
TEST(SceneBounds, WhatStartsFoldedIsInsideStretchedOut) {
  Toy toy = pendulum();
  toy.particles = {Eigen::VectorXd::Ones(3), {1, 0, 0}};
  toy.start = {Eigen::VectorXd::Zero(9), Eigen::VectorXd::Zero(9)};
  toy.start.x[3] = 0.5;
  toy.constraints.rods.push_back({1, 2, 0.5});
  expect_inside(bounds_of(toy), Vector3d(0, 0, -1));
}

TEST(SceneBounds, WhatNothingHoldsFalls) {
  Toy toy = pendulum();
  toy.particles.pinned = {0, 0};
  EXPECT_NEAR(bounds_of(toy).min()[2], -9.81 / 2, 1e-12);
}

TEST(SceneDrawing, EachParticleIsDrawnWhereTheStateHasIt) {
  Scene scene = moving_head();
  scene.toys.push_back(pendulum());
  particles::State state{Eigen::VectorXd::LinSpaced(18, 0, 17), Eigen::VectorXd::Zero(18)};
  const Drawing drawing = SceneDrawing(scene, {4}).at(state, scene.hair.obstacles, 0);
  EXPECT_EQ(drawing.strands.sizes, std::vector<int>{4});
  EXPECT_EQ(drawing.strands.points[3], Vector3d(9, 10, 11));
  ASSERT_EQ(drawing.balls.size(), 2U);
  EXPECT_EQ(drawing.balls[1].centre, Vector3d(15, 16, 17));
  ASSERT_EQ(drawing.tubes.size(), 1U);
  EXPECT_EQ(drawing.tubes[0].a, Vector3d(12, 13, 14));
  EXPECT_EQ(drawing.obstacles.size(), 1U);
}

TEST(SceneDrawing, ClothIsASheetAndNotItsSprings) {
  Scene scene;
  Toy cloth;
  cloth.particles = {Eigen::VectorXd::Ones(7), std::vector<char>(7, 0)};
  cloth.start = {Eigen::VectorXd::LinSpaced(21, 0, 1), Eigen::VectorXd::Zero(21)};
  cloth.springs = {{0, 1, 1, 1}, {4, 5, 1, 1}, {5, 6, 1, 1}};
  cloth.rows = 2;
  cloth.columns = 3;
  scene.toys = {cloth};
  const Drawing drawing = SceneDrawing(scene, {}).at(cloth.start, {}, 0);
  ASSERT_EQ(drawing.sheets.size(), 1U);
  EXPECT_EQ(drawing.sheets[0].points.size(), 6U);
  EXPECT_EQ(drawing.tubes.size(), 1U) << "the spring that leads away from it";
  EXPECT_EQ(drawing.balls.size(), 1U);
}

TEST(SceneDrawing, ASolidIsAMeshWhereItIsNowAndInsideTheBounds) {
  Scene scene = moving_head();
  scene.hair.obstacles.push_back(placed_ball({3, -2, 0.5}, 0.2));
  scene.riders[0].obstacles.push_back(1);
  const Bounds bounds = scene_bounds(scene);
  for (const Vector3d& at : {Vector3d(3, -2, 0.5), Vector3d(3, -1, 0.5)})
    for (const int side : {-1, 1}) expect_inside(bounds, at.array() + 0.99 * side * 0.2);
  std::vector<Obstacle> now = scene.hair.obstacles;
  auto& placed = std::get<PlacedSolid>(now[1].shape);
  placed.at += Vector3d(0, 1, 0);
  placed.rotation = Eigen::AngleAxisd(1, Vector3d::UnitX()) * placed.rotation;
  const Drawing drawing =
      SceneDrawing(scene, {4}).at({Eigen::VectorXd::Zero(12), Eigen::VectorXd::Zero(12)}, now, 1);
  ASSERT_EQ(drawing.meshes.size(), 1U);
  const PlacedMesh& mesh = drawing.meshes[0];
  ASSERT_FALSE(mesh.mesh->points.empty());
  for (const Vector3d& point : mesh.mesh->points)
    EXPECT_NEAR(surface_at(now[1], mesh.rotation * point + mesh.at).distance, 0, 1e-6);
}

TEST(SceneDrawing, RefusesAStateOfAnotherSize) {
  const Scene scene = moving_head();
  const particles::State state{Eigen::VectorXd::Zero(15), Eigen::VectorXd::Zero(15)};
  EXPECT_THROW(SceneDrawing(scene, {4}).at(state, {}, 0), std::invalid_argument);
}

TEST(SceneDrawing, ASceneWithALookIsDrawnInItsSize) {
  Scene scene = moving_head();
  scene.look = Look{.image_width = 320, .image_height = 180, .shadows = false};
  const RenderSettings settings = SceneDrawing(scene, {}).settings();
  EXPECT_EQ(settings.width, 320);
  EXPECT_EQ(settings.height, 180);
  EXPECT_FALSE(settings.shadows);
}

}  // namespace
}  // namespace hair
