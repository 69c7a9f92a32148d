// Dense hair near solids, without a scene.
#include "hair/render/strand_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hair/head/bust.h"
#include "hair/head/scalp_roots.h"

namespace hair {
namespace {

constexpr int kPoints = 18;

// Straight strands of a bust's scalp, 30 cm long, in any direction: most go through face, neck or shoulders.
StrandsDrawing through_the_bust(int count) {
  StrandsDrawing strands;
  for (const RootFrame& root : scalp_roots(Bust(), count, 3)) {
    const auto angle = static_cast<double>(strands.sizes.size());
    const Vector3d way = (Vector3d(std::cos(angle), std::sin(angle), -2) + 0.5 * root.axis).normalized();
    strands.sizes.push_back(kPoints);
    for (int i = 0; i < kPoints; ++i) strands.points.push_back(root.position + 0.3 * i / (kPoints - 1) * way);
  }
  return strands;
}

PlacedSolid turned_bust() {
  return {std::make_shared<Bust>(), Vector3d(0.3, -0.2, 1),
          Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()))};
}

StrandsDrawing carried(StrandsDrawing strands, const PlacedSolid& by) {
  for (Vector3d& point : strands.points) point = by.at + by.rotation * point;
  return strands;
}

// The largest depth of all points except roots, m; below 0 if all are outside.
double deepest(const std::vector<Obstacle>& obstacles, const StrandsDrawing& strands) {
  double depth = -1;
  for (std::size_t i = 0; i < strands.points.size(); ++i)
    for (const Obstacle& obstacle : obstacles)
      if (i % kPoints != 0) depth = std::max(depth, -surface_at(obstacle, strands.points[i]).distance);
  return depth;
}

TEST(StrandClearance, LeavesNoPointInsideOfABust) {
  const PlacedSolid bust = turned_bust();
  // The grid is made for the solid's position at the start.
  StrandClearance clearance({{PlacedSolid{bust.solid}}});
  const std::vector<Obstacle> now = {{bust}};
  StrandsDrawing strands = carried(through_the_bust(2000), bust);
  const std::vector<Vector3d> before = strands.points;
  EXPECT_GT(deepest(now, strands), 0.02);
  const long moved = clearance.move_out(now, strands, 0, 0);
  EXPECT_LE(deepest(now, strands), StrandClearance::kTolerance);
  long others = 0;
  for (std::size_t i = 0; i < before.size(); i += kPoints) {
    EXPECT_EQ(strands.points[i], before[i]) << "a root stays";
    others += !std::equal(&before[i], &before[i] + kPoints, &strands.points[i]);
  }
  EXPECT_EQ(moved, others);
}

TEST(StrandClearance, LeavesNoPointInsideOfRoundThingsOrTheGround) {
  const std::vector<Obstacle> now = {{Sphere{{0, 0, -0.05}, 0.08}},
                                     {Capsule{{-0.2, 0.03, -0.25}, {0.2, 0.03, -0.25}, 0.04}},
                                     {Plane{{0, 0, -0.3}, {0, 0, 1}}}};
  StrandClearance clearance(now);
  StrandsDrawing strands = through_the_bust(2000);
  EXPECT_GT(deepest(now, strands), 0.02);
  clearance.move_out(now, strands, 0, 0);
  EXPECT_LE(deepest(now, strands), StrandClearance::kTolerance);
}

TEST(StrandClearance, LeavesAloneWhatIsClear) {
  const std::vector<Obstacle> now = {{PlacedSolid{std::make_shared<Bust>()}}};
  StrandClearance clearance(now);
  StrandsDrawing strands;
  for (const RootFrame& root : scalp_roots(Bust(), 200, 1)) {
    strands.sizes.push_back(kPoints);
    // Upright hair. It must not be nearer than kLow, nor nearer than a slope of a quarter allows.
    for (int i = 0; i < kPoints; ++i) strands.points.push_back(root.position + 0.01 * i * root.axis);
  }
  const std::vector<Vector3d> before = strands.points;
  EXPECT_EQ(clearance.move_out(now, strands, 0, 0), 0);
  EXPECT_EQ(strands.points, before);
}

// A strand that dips into a ball by a few millimetres slides over it: it keeps its length to the square of
// the angle that it turns by. At one joint it bends by no more than its points would turn along the ball, and
// as much again for its two ends.
TEST(StrandClearance, KeepsLengthsAndMakesNoKink) {
  constexpr double radius = 0.1, depth = 0.004, piece = 0.01;
  const std::vector<Obstacle> ball = {{Sphere{{0, 0, 0}, radius}}};
  StrandClearance clearance(ball);
  StrandsDrawing strands;
  constexpr int count = 31;
  strands.sizes = {count};
  for (int i = 0; i < count; ++i) strands.points.emplace_back(piece * (i - 15), 0, radius - depth);
  clearance.move_out(ball, strands, 0, 0);
  double length = 0, bend = 0;
  for (int i = 1; i < count; ++i) {
    const Vector3d after = strands.points[i] - strands.points[i - 1];
    length += after.norm();
    if (i < 2) continue;
    const Vector3d before = strands.points[i - 1] - strands.points[i - 2];
    bend = std::max(bend, std::atan2(before.cross(after).norm(), before.dot(after)));
  }
  // Half of the angle under which the ball's middle sees the part that was inside.
  const double half = std::acos(1 - depth / radius);
  EXPECT_NEAR(length, piece * (count - 1), 0.5 * half * half * 2 * half * radius);
  EXPECT_LE(bend, half) << "as a straight line would turn that meets the ball there";
  EXPECT_LE(bend, 2 * piece / radius);
  EXPECT_GT(bend, 0);
}

// Hair that would go into the ground at 45 degrees lies on it. If it only moved up, a piece would have cos 45
// degrees of its length. Moves are smoothed over nine points either way, so from the tenth point after the
// corner to the tenth before the tip, nothing bends: lengths are exact up to the rounding of coordinates
// below 1 m.
TEST(StrandClearance, RestoresTheLengthsOfWhatLiesOnTheGround) {
  constexpr double piece = 0.01;
  constexpr int count = 61, corner = 10, smoothed = 10;
  const std::vector<Obstacle> ground = {{Plane{{0, 0, 0}, {0, 0, 1}}}};
  StrandClearance clearance(ground);
  StrandsDrawing strands;
  strands.sizes = {count};
  for (int i = 0; i < count; ++i)
    strands.points.emplace_back(piece * std::sqrt(0.5) * Vector3d(i, 0, corner - i));
  clearance.move_out(ground, strands, 0, 0);
  for (int i = corner + smoothed + 1; i < count - smoothed; ++i)
    EXPECT_NEAR((strands.points[i] - strands.points[i - 1]).norm(), piece, 1e-15) << "piece " << i;
}

TEST(StrandClearance, IsTheSameWithAnyNumberOfThreadsAndWhateverElseIsThere) {
  const std::vector<Obstacle> now = {{PlacedSolid{std::make_shared<Bust>()}}};
  StrandClearance one(now), three(now, 3);
  const StrandsDrawing all = through_the_bust(500);
  StrandsDrawing first = all, second = all, last = all;
  EXPECT_EQ(one.move_out(now, first, 0, 0), three.move_out(now, second, 0, 0));
  EXPECT_EQ(first.points, second.points);
  one.move_out(now, last, 300, 300 * kPoints);
  EXPECT_TRUE(std::equal(all.points.begin(), all.points.begin() + 300 * kPoints, last.points.begin()));
  EXPECT_TRUE(std::equal(first.points.begin() + 300 * kPoints, first.points.end(),
                         last.points.begin() + 300 * kPoints));
}

}  // namespace
}  // namespace hair
