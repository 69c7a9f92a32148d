// STAFF ONLY. Tests triangulations of points, and that roots between guides lie on the scalp, evenly.
#include "hair/dense/triangulation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "hair/dense/roots_between.h"
#include "hair/dense/test_guides.h"

namespace reference_tests {
namespace {

using Eigen::Vector2d;
using hair::Triangulation;

using hair::roots_between;

std::vector<Vector2d> points_by_chance(int count) {
  std::mt19937_64 engine(count);
  std::vector<Vector2d> points;
  const auto number = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  for (int i = 0; i < count; ++i) {
    const double x = number();
    points.emplace_back(x, number());
  }
  return points;
}

double area_of(const Triangulation& triangulation, const Triangulation::Triangle& triangle) {
  const Vector2d a = triangulation.points[triangle.corners[0]],
                 u = triangulation.points[triangle.corners[1]] - a,
                 v = triangulation.points[triangle.corners[2]] - a;
  return (u.x() * v.y() - u.y() * v.x()) / 2;
}

// Centre and radius of the circle through the corners.
std::pair<Vector2d, double> circle_of(const Triangulation& triangulation,
                                      const Triangulation::Triangle& triangle) {
  const Vector2d a = triangulation.points[triangle.corners[0]],
                 u = triangulation.points[triangle.corners[1]] - a,
                 v = triangulation.points[triangle.corners[2]] - a;
  const double d = 2 * (u.x() * v.y() - u.y() * v.x());
  const Vector2d from_a((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / d,
                        (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / d);
  return {a + from_a, from_a.norm()};
}

TEST(Triangulation, NoPointLiesInACircleThroughCorners) {
  const Triangulation triangulation = hair::triangulate(points_by_chance(300));
  ASSERT_GT(triangulation.triangles.size(), 550u);  // Euler: 2 n - 2 less the number on the rim
  for (const Triangulation::Triangle& triangle : triangulation.triangles) {
    ASSERT_GT(area_of(triangulation, triangle), 0);
    const auto [centre, radius] = circle_of(triangulation, triangle);
    // Points were moved by a millionth, which moves wide circles by more.
    const double slack = 1e-5 * (1 + radius * radius / area_of(triangulation, triangle));
    for (const Vector2d& point : triangulation.points)
      EXPECT_GE((point - centre).norm(), radius - slack) << "a circle with a radius of " << radius;
  }
}

TEST(Triangulation, CoversWhatLiesBetweenPoints) {
  for (const int count : {3, 10, 1000, 10'000}) {
    std::vector<Vector2d> points = points_by_chance(count - 4 > 0 ? count - 4 : 0);
    for (const Vector2d& corner : {Vector2d(0, 0), Vector2d(1, 0), Vector2d(1, 1), Vector2d(0, 1)})
      if (static_cast<int>(points.size()) < count) points.push_back(corner);
    const Triangulation triangulation = hair::triangulate(points);
    double area = 0;
    for (const Triangulation::Triangle& triangle : triangulation.triangles)
      area += area_of(triangulation, triangle);
    // On each of the four sides, a circle through far corners, 1000 widths wide, may hold other points: a
    // segment of 2/3 / 8000.
    EXPECT_NEAR(area, count == 3 ? 0.5 : 1, 4e-4) << count << " points";
  }
}

// Grids have four points on each circle.
TEST(Triangulation, OfAGridHasTwoTrianglesInEachSquare) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) points.emplace_back(i, j);
  const Triangulation triangulation = hair::triangulate(points);
  double area = 0;
  for (const Triangulation::Triangle& triangle : triangulation.triangles)
    area += area_of(triangulation, triangle);
  EXPECT_NEAR(area, 19 * 19, 1e-2);
}

TEST(Triangulation, NeighboursAgree) {
  const Triangulation triangulation = hair::triangulate(points_by_chance(500));
  for (std::size_t i = 0; i < triangulation.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const int next = triangulation.triangles[i].neighbours[k];
      if (next < 0) continue;
      const auto& back = triangulation.triangles[next].neighbours;
      EXPECT_EQ(std::count(back.begin(), back.end(), static_cast<int>(i)), 1);
    }
}

TEST(Triangulation, FindsTheTriangleOfAPoint) {
  const Triangulation triangulation = hair::triangulate(points_by_chance(400));
  int from = 0, inside = 0;
  for (const Vector2d& at : points_by_chance(1001)) {
    from = triangulation.triangle_at(at, from);
    const auto& corners = triangulation.triangles[from].corners;
    bool holds = true;
    for (int k = 0; k < 3; ++k) {
      const Vector2d u = triangulation.points[corners[(k + 1) % 3]] - triangulation.points[corners[k]],
                     v = at - triangulation.points[corners[k]];
      holds = holds && (u.x() * v.y() - u.y() * v.x() >= 0 ||
                        triangulation.triangles[from].neighbours[(k + 2) % 3] < 0);
    }
    EXPECT_TRUE(holds) << at.transpose();
    inside += holds;
  }
  EXPECT_EQ(inside, 1001);
}

TEST(Triangulation, OfALineHasNoTriangles) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 30; ++i) points.emplace_back(i, 0.5 * i);
  EXPECT_TRUE(hair::triangulate(points).triangles.empty());
  EXPECT_TRUE(hair::triangulate({Vector2d(1, 1), Vector2d(1, 1), Vector2d(1, 1)}).triangles.empty());
  EXPECT_TRUE(hair::triangulate({Vector2d(1, 1), Vector2d(2, 1)}).triangles.empty());
  EXPECT_TRUE(hair::triangulate({}).triangles.empty());
}

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
