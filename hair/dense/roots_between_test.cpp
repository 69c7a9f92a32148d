// STAFF ONLY. Tests that roots between guides lie on the scalp, evenly.
#include "hair/dense/roots_between.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hair/dense/test_guides.h"

namespace reference_tests {
namespace {

using hair::roots_between;

TEST(RootsBetween, LieOnTheScalpWithItsNormals) {
  constexpr double ball = 0.1;
  const std::vector<RootFrame> scalp = roots_on_ball(400, ball, 2);
  const std::vector<RootFrame> roots = roots_between(scalp, 3000, 1);
  ASSERT_EQ(roots.size(), 3000U);
  // Each root has this area, and a triangle of evenly spaced roots the side 1.07 sqrt(area). No triangle
  // three times as long remains, and the middle of a triangle is side^2 / 6 ball below the ball.
  const double area = 2 * M_PI * ball * ball * (1 - std::cos(2)) / 400, side = 3 * 1.07 * std::sqrt(area);
  for (const RootFrame& root : roots) {
    EXPECT_NEAR(root.position.norm(), ball, side * side / (6 * ball));
    EXPECT_GT(root.axis.dot(root.position.normalized()), std::cos(0.5 * side / ball));
    EXPECT_NEAR(root.axis.norm(), 1, 1e-14);
  }
}

// Each triangle gets its part of the roots, rounded: a quarter of a square gets a quarter, except for one
// root in each triangle that it cuts.
TEST(RootsBetween, AreEvenlySpread) {
  std::vector<RootFrame> square;
  for (int i = 0; i <= 10; ++i)
    for (int k = 0; k <= 10; ++k) square.push_back({Vector3d(i, k, 0), Vector3d::UnitZ(), Vector3d::UnitX()});
  constexpr int count = 20'000;
  std::array<int, 4> quarters{};
  for (const RootFrame& root : roots_between(square, count, 5))
    ++quarters[(root.position.x() > 5 ? 1U : 0U) + (root.position.y() > 5 ? 2U : 0U)];
  for (const int quarter : quarters) EXPECT_NEAR(quarter, 0.25 * count, 10);
}

TEST(RootsBetween, LeaveBaysOfTheHairlineFree) {
  // Two patches far from each other.
  std::vector<RootFrame> scalp;
  for (const double x : {0.0, 10.0})
    for (int i = 0; i < 5; ++i)
      for (int k = 0; k < 5; ++k)
        scalp.push_back({Vector3d(x + 0.5 * i, 0.5 * k, 0), Vector3d::UnitZ(), Vector3d::UnitX()});
  for (const RootFrame& root : roots_between(scalp, 500, 1))
    EXPECT_TRUE(root.position.x() <= 2 || root.position.x() >= 10) << root.position.transpose();
}

TEST(RootsBetween, ASeedGivesTheSameAndAnotherOthersAndALineHasNone) {
  const std::vector<RootFrame> scalp = roots_on_disc(30, 1);
  const auto positions = [&](std::uint64_t seed) {
    std::vector<Vector3d> all;
    for (const RootFrame& root : roots_between(scalp, 50, seed)) all.push_back(root.position);
    return all;
  };
  EXPECT_EQ(positions(1), positions(1));
  EXPECT_NE(positions(1), positions(2));
  std::vector<RootFrame> line;
  for (int i = 0; i < 4; ++i) line.push_back({Vector3d(i, 0, 0), Vector3d::UnitZ(), Vector3d::UnitX()});
  EXPECT_TRUE(roots_between(line, 5, 1).empty());
  EXPECT_TRUE(roots_between({}, 5, 1).empty());
}

}  // namespace
}  // namespace reference_tests
