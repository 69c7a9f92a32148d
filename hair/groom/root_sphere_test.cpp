#include "hair/groom/root_sphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hair/groom/farthest_points.h"
#include "hair/strand/variation.h"

namespace hair {
namespace {

constexpr double kBall = 0.1;
const Vector3d kMiddle(1, -2, 0.5);

// Roots on the upper part of a ball; hair leaves it between outwards and down.
std::vector<RootFrame> cap(int count) {
  Variation variation(1);
  std::vector<RootFrame> roots;
  for (int i = 0; i < count; ++i) {
    const double z = variation.uniform(0.2, 1), turn = variation.uniform(0, 2 * M_PI);
    const Vector3d out(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    const Vector3d way = (out - Vector3d::UnitZ() + 0.1 * Vector3d::UnitX()).normalized();
    roots.push_back({kMiddle + kBall * out, way, side_of(way)});
  }
  return roots;
}

std::vector<Vector3d> places(const std::vector<RootFrame>& roots) {
  std::vector<Vector3d> points;
  for (const RootFrame& root : roots) points.push_back(root.position);
  return points;
}

// The middle of the ball is 20 radii away from the origin: positions are rounded to 4e-16, and the visible
// part gives the centre with a condition number of some tens.
TEST(RootSphere, IsTheBallThatRootsAreOn) {
  const auto sphere = sphere_through(places(cap(50)));
  ASSERT_TRUE(sphere);
  EXPECT_LE((sphere->centre - kMiddle).norm(), 1e-13);
  EXPECT_NEAR(sphere->radius, kBall, 1e-13);
}

TEST(RootSphere, IsNoneForRootsOnAPlaneAndForFew) {
  std::vector<Vector3d> flat;
  for (int i = 0; i < 100; ++i) flat.emplace_back(std::sin(i), std::cos(2.0 * i), 1e-3 * std::sin(5.0 * i));
  EXPECT_FALSE(sphere_through(flat));
  EXPECT_FALSE(sphere_through({}));
  EXPECT_FALSE(sphere_through(places(cap(3))));
}

TEST(ScalpOfRoots, HasTheNormalsOfTheBall) {
  const std::vector<RootFrame> roots = cap(60), scalp = scalp_of_roots(roots);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_EQ(scalp[i].position, roots[i].position);
    EXPECT_LE((scalp[i].axis - (roots[i].position - kMiddle) / kBall).norm(), 1e-12);
    EXPECT_NEAR(scalp[i].axis.dot(scalp[i].side), 0, 1e-15);
  }
}

TEST(ScalpOfRoots, OnAPlaneLooksToWhereHairIs) {
  for (const double side : {1.0, -1.0}) {
    std::vector<RootFrame> roots;
    for (int i = 0; i < 20; ++i) {
      const Vector3d way = Vector3d(1, 0, 0.3 * side).normalized();
      roots.push_back({Vector3d(std::sin(i), std::cos(i), 2), way, side_of(way)});
    }
    for (const RootFrame& root : scalp_of_roots(roots))
      EXPECT_LE((root.axis - side * Vector3d::UnitZ()).norm(), 1e-12);
  }
}

TEST(ScalpOfRoots, OnALineStaysWhatItIs) {
  const Vector3d way = Vector3d(1, 2, 3).normalized();
  std::vector<RootFrame> roots;
  for (int i = 0; i < 5; ++i) roots.push_back({Vector3d(0.1 * i, 0, 0), way, side_of(way)});
  for (const RootFrame& root : scalp_of_roots(roots)) EXPECT_EQ(root.axis, way);
  EXPECT_TRUE(scalp_of_roots({}).empty());
}

// Each chosen point is at least as far from the others as any point is from the nearest chosen one. So no
// point is more than twice as far as necessary (Gonzalez).
TEST(FarthestPoints, AreAsFarFromEachOtherAsAnyPointIsFromThem) {
  const std::vector<Vector3d> points = places(cap(500));
  const std::vector<std::size_t> taken = farthest_points(points, 40);
  ASSERT_EQ(taken.size(), 40U);
  EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
  const auto nearest = [&](std::size_t to) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t one : taken)
      if (one != to) least = std::min(least, (points[one] - points[to]).norm());
    return least;
  };
  double apart = 1, farthest = 0;
  for (const std::size_t one : taken) apart = std::min(apart, nearest(one));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::binary_search(taken.begin(), taken.end(), i)) farthest = std::max(farthest, nearest(i));
  EXPECT_GE(apart, farthest);
}

TEST(FarthestPoints, AreAllIfThereAreNoMoreAndOneOfThoseAtOnePlace) {
  const std::vector<Vector3d> points = {Vector3d::Zero(), Vector3d::UnitX(), Vector3d::Zero(),
                                        Vector3d::UnitX()};
  EXPECT_EQ(farthest_points(points, 9).size(), 4U);
  EXPECT_EQ(farthest_points(points, 3).size(), 2U);
  EXPECT_TRUE(farthest_points({}, 3).empty());
}

}  // namespace
}  // namespace hair
