// STAFF ONLY. Scenes made from texts.
#include <gtest/gtest.h>

#include <cmath>

#include "hair/scene/scene.h"
#include "hair/scene/test_reading.h"

namespace reference_tests {
namespace {

using Eigen::Vector3d;
using hair::Scene;

Scene read(const std::string& text) {
  return hair::parse_scene(text, "folder/a.json");
}

TEST(ReadScene, EverythingIsWhereItsKeySays) {
  const Scene scene = read(small_scene());
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(scene.shows, "all kinds of things");
  EXPECT_EQ(scene.frames, 2);
  EXPECT_EQ(scene.steps_per_frame, 8);
  EXPECT_EQ(scene.hair.step, 1.0 / 240);
  EXPECT_EQ(scene.hair.method, hair::Method::predictor_corrector);
  EXPECT_EQ(scene.hair.wind, Vector3d(0, 1, 0));
  EXPECT_EQ(scene.hair.drag, 1e-4);
  ASSERT_EQ(scene.hair.strands.size(), 8U);
  EXPECT_TRUE(scene.hair.strands[0].strand.clamped);
  EXPECT_EQ(scene.hair.strands[0].rest_curvature.size(), 8);
  EXPECT_EQ(scene.hair.strands[1].state.v.head<3>(), Vector3d(0, 0, 1));
  EXPECT_FALSE(scene.hair.strands[3].strand.clamped);
  EXPECT_EQ(scene.hair.strands[3].rest_curvature.size(), 0);
  EXPECT_EQ(scene.hair.strands[4].state.x, (Eigen::VectorXd(6) << 0.5, 0, 0, 0.5, 0.1, 0).finished());
  ASSERT_EQ(scene.hair.obstacles.size(), 3U);
  EXPECT_EQ(scene.hair.obstacles[0].friction, 0.5);
  EXPECT_EQ(std::get<hair::Sphere>(scene.hair.obstacles[1].shape).radius, 0.1);
  EXPECT_EQ(std::get<hair::Capsule>(scene.hair.obstacles[2].shape).b, Vector3d(1, 0, -0.5));
  ASSERT_EQ(scene.riders.size(), 1U);
  EXPECT_EQ(scene.riders[0].strands, std::vector<int>{0});
  EXPECT_EQ(scene.riders[0].obstacles, std::vector<int>{1});
  EXPECT_EQ(scene.riders[0].motion.keys[1].pose.position, Vector3d(0, 0, 1));
  EXPECT_NEAR((scene.riders[0].motion.keys[1].pose.rotation * Vector3d::UnitX() - Vector3d::UnitY()).norm(),
              0, 1e-15);
  ASSERT_EQ(scene.toys.size(), 2U);
  EXPECT_TRUE(scene.toys[0].particles.is_pinned(0));
  EXPECT_EQ(scene.toys[0].start.v[4], 1);
  EXPECT_EQ(scene.toys[0].constraints.rods[0].length, 1);
  EXPECT_EQ(scene.toys[0].constraints.wires[0].radius, 2);
  EXPECT_EQ(scene.toys[0].gravity, Vector3d(0, 0, -9.81));
  EXPECT_EQ(scene.toys[0].drag, 0.01);
  EXPECT_EQ(scene.toys[1].rows, 3);
  EXPECT_EQ(scene.toys[1].method, hair::ToyMethod::implicit_euler);
  ASSERT_TRUE(scene.look);
  EXPECT_EQ(scene.look->image_width, 640);
  EXPECT_EQ(scene.look->tip_colour, Vector3d(1, 1, 1));
  EXPECT_FALSE(scene.look->shadows);
  EXPECT_TRUE(scene.look->links);
}

TEST(ReadScene, WhatIsNotSaidIsLeftOut) {
  const Scene scene = read(R"({"shows": "a hair", "frames": 1, "hair": [
    {"segments": 2, "length": 0.2, "roots": {"list": [{"position": [0, 0, 1]}]}}]})");
  EXPECT_TRUE(scene.riders.empty());
  EXPECT_TRUE(scene.toys.empty());
  EXPECT_FALSE(scene.look);
  EXPECT_TRUE(scene.hair.obstacles.empty());
  EXPECT_EQ(scene.hair.drag, 0);
  EXPECT_EQ(scene.hair.strands[0].state.x, (Eigen::VectorXd(9) << 0, 0, 1, 0, 0, 0.9, 0, 0, 0.8).finished());
  EXPECT_EQ(scene.hair.strands[0].strand.stretch_rigidity, hair::Material{}.stretch_rigidity());
  EXPECT_EQ(scene.hair.strands[0].strand.skip_rigidity, 0);
}

TEST(ReadScene, AStepGivesTheStepsOfAFrame) {
  const Scene scene = read(small_scene(R"("steps_per_frame": 8)", R"("step": 0.0041666666666666666)"));
  EXPECT_EQ(scene.steps_per_frame, 8);
  EXPECT_EQ(scene.hair.step, 1.0 / 240);
}

TEST(ReadScene, TheSameTextGivesTheSameBits) {
  const Scene one = read(small_scene()), two = read(small_scene());
  for (std::size_t i = 0; i < one.hair.strands.size(); ++i)
    EXPECT_EQ(one.hair.strands[i].state.x, two.hair.strands[i].state.x);
}

// The strands of two seeds differ, and within the requested bounds.
TEST(ReadScene, VariationKeepsItsBounds) {
  const auto scene = [](const std::string& variation) {
    return read(R"({"shows": "a row", "frames": 1, "hair": [{"segments": 5, "length": 1, "variation": {)" +
                variation + R"(}, "roots": {"line": {"from": [0, 0, 0], "to": [1, 0, 0], "count": 200}}}]})");
  };
  const Scene one = scene(R"("seed": 1, "length": 0.2, "tilt": 10)");
  const Scene two = scene(R"("seed": 2, "length": 0.2, "tilt": 10)");
  double shortest = 2, longest = 0, widest = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    const hair::StrandStart& start = one.hair.strands[i];
    EXPECT_NE(start.state.x, two.hair.strands[i].state.x);
    const double length = start.strand.rest_length.sum();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    widest = std::max(widest, std::acos(-start.strand.root_tangent.z()) * 180 / M_PI);
  }
  EXPECT_GE(shortest, 0.8 - 1e-12);
  EXPECT_LE(longest, 1.2 + 1e-12);
  EXPECT_LE(widest, 10 + 1e-6);
  // 200 uniform numbers come within a tenth of either end, except with the probability 2 * 0.95^200 = 7e-5;
  // the seed is fixed.
  EXPECT_LE(shortest, 0.82);
  EXPECT_GE(longest, 1.18);
  EXPECT_GE(widest, 9);
}

TEST(ReadScene, HairIsHeldAsItsStartSays) {
  const auto start = [](const std::string& how) {
    return read(R"({"shows": "a hair", "frames": 1, "hair": [{"segments": 2, "length": 2, "start": {)" + how +
                R"(}, "roots": {"list": [{"position": [0, 0, 0]}]}}]})")
        .hair.strands[0];
  };
  EXPECT_EQ(start(R"("direction": [3, 0, 0])").state.x,
            (Eigen::VectorXd(9) << 0, 0, 0, 1, 0, 0, 2, 0, 0).finished());
  EXPECT_EQ(start(R"("direction": [0, 2, 0], "folded": true)").state.x,
            (Eigen::VectorXd(9) << 0, 0, 0, 0, 1, 0, 0, 0, 0).finished());
  const hair::StrandStart half = start(R"("direction": [1, 0, 0], "stretch": 0.5)");
  EXPECT_EQ(half.state.x, (Eigen::VectorXd(9) << 0, 0, 0, 0.5, 0, 0, 1, 0, 0).finished());
  EXPECT_EQ(half.strand.rest_length[0], 1);
  EXPECT_EQ(half.strand.root_tangent, Vector3d(0, 0, -1));
}

TEST(ReadScene, RigiditiesHaveTheirFactors) {
  const Scene scene = read(small_scene(R"("stretch_factor": 1, "bend_factor": 1,
                   "twist_factor": 1, "skip_factor": 0)",
                                       R"("stretch_factor": 100, "bend_factor": 0, "skip_factor": 0.1)"));
  const hair::Strand& strand = scene.hair.strands[0].strand;
  EXPECT_DOUBLE_EQ(strand.stretch_rigidity, 100 * hair::Material{}.stretch_rigidity());
  EXPECT_EQ(strand.bend_rigidity, 0);
  EXPECT_DOUBLE_EQ(strand.skip_rigidity, 10 * hair::Material{}.stretch_rigidity());
}

TEST(ReadScene, HairGrowsOutOfItsHead) {
  const Scene scene = read(R"({"shows": "a head", "frames": 1, "hair": [{"segments": 10, "length": 0.3,
    "roots": {"cap": {"centre": [1, 2, 3], "radius": 0.1, "degrees": 110, "count": 300}}}]})");
  const Vector3d centre(1, 2, 3);
  for (const hair::StrandStart& start : scene.hair.strands) {
    EXPECT_NEAR((start.state.x.head<3>() - centre).norm(), 0.1, 1e-15);
    EXPECT_GE(start.state.x[2], 3 + 0.1 * std::cos(110 * M_PI / 180) - 1e-12);
    for (Eigen::Index k = 3; k < start.state.x.size(); k += 3)
      EXPECT_GT((start.state.x.segment<3>(k) - centre).norm(), 0.1);
  }
}

// A scene without a method uses the usual one of its hair.
TEST(ReadScene, HairWithoutAMethodMovesByItsOwn) {
  const auto method_of = [](const std::string& model, const std::string& more) {
    return hair::parse_scene(R"({"shows": "a hair", "frames": 1, "hair": [{"model": ")" + model +
                                 R"(", "segments": 3, "length": 0.1, "roots": {"line": {"from": [0, 0, 0],
                                 "to": [0.1, 0, 0], "count": 2}}}])" +
                                 more + "}",
                             "scene")
        .hair.method;
  };
  EXPECT_EQ(method_of("mass_spring", ""), hair::Method::predictor_corrector);
  EXPECT_EQ(method_of("mass_spring", R"(, "links": {"stiffness": 1})"), hair::Method::implicit_euler);
  EXPECT_EQ(method_of("rigid_links", ""), hair::Method::implicit_euler);
  EXPECT_EQ(method_of("super_helix", ""), hair::Method::implicit_euler);
  EXPECT_EQ(method_of("rigid_links", R"(, "method": "runge_kutta_4")"), hair::Method::runge_kutta_4);
}

}  // namespace
}  // namespace reference_tests
