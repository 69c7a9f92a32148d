// STAFF ONLY. Tests triangulations of points.
#include "hair/dense/triangulation.h"

#include <gtest/gtest.h>

#include <random>

namespace reference_tests {
namespace {

using Eigen::Vector2d;
using hair::Triangulation;

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

}  // namespace
}  // namespace reference_tests
