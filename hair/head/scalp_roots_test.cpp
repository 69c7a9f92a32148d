#include "hair/head/scalp_roots.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/groom/groom_measures.h"
#include "hair/groom/nearest_points.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/strand/variation.h"

namespace hair {
namespace {

TEST(EllipsoidHead, ADistanceIsZeroOnTheSurfaceAndRisesAlongTheNormal) {
  const EllipsoidHead head({0.07, 0.09, 0.12}, {1, 2, 3});
  Variation variation(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3d way =
        Vector3d(variation.uniform(-1, 1), variation.uniform(-1, 1), variation.uniform(-1, 1)).normalized();
    const Vector3d point = head.surface_towards(way);
    const Surface at = head.surface_at(point);
    EXPECT_NEAR(at.distance, 0, 1e-15);
    EXPECT_NEAR(at.normal.norm(), 1, 1e-15);
    EXPECT_NEAR((point - head.centre()).normalized().dot(way), 1, 1e-15);
    // To first order: the second-order term is half a curvature, of at most 0.12 / 0.07^2, times the square.
    for (const double d : {1e-4, -1e-4})
      EXPECT_NEAR(head.surface_at(point + d * at.normal).distance, d, 25 * d * d);
    EXPECT_LT(head.surface_at(head.centre() + 0.5 * (point - head.centre())).distance, 0);
    EXPECT_GT(head.surface_at(head.centre() + 2 * (point - head.centre())).distance, 0);
    EXPECT_NEAR(head.combed(point).dot(at.normal), 0, 1e-14);
  }
  EXPECT_THROW(EllipsoidHead({0.1, 0, 0.1}), std::invalid_argument);
}

class Roots : public testing::TestWithParam<int> {
 protected:
  const EllipsoidHead head_;
  const std::vector<RootFrame> roots_ = scalp_roots(head_, GetParam(), 1);
};

TEST_P(Roots, AreFramesOnTheScalp) {
  ASSERT_EQ(roots_.size(), static_cast<std::size_t>(GetParam()));
  for (const RootFrame& root : roots_) {
    EXPECT_NEAR(head_.surface_at(root.position).distance, 0, 1e-15);
    EXPECT_TRUE(head_.has_hair(root.position));
    EXPECT_EQ(root.axis, head_.surface_at(root.position).normal);
    EXPECT_NEAR(root.side.norm(), 1, 1e-14);
    EXPECT_NEAR(root.side.dot(root.axis), 0, 1e-14);
  }
}

// Random points have the next one at 0.5 of the spacing on average, and some at nearly 0. Points of a lattice
// have it at 0.8 to 1.05; a move of 0.2 at each end takes at most 0.4.
TEST_P(Roots, AreEvenlyApart) {
  const double spacing = std::sqrt(Scalp(head_).area() / GetParam());
  std::vector<Vector3d> points;
  for (const RootFrame& root : roots_) points.push_back(root.position);
  const NearestPoints tree(points);
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.size(); ++i)
    distances.push_back(tree.nearest(points[i], static_cast<long>(i)).distance / spacing);
  const Spread spread = spread_of(distances);
  EXPECT_GT(spread.min, 0.35);
  EXPECT_GT(spread.mean, 0.7);
  EXPECT_LT(spread.mean, 1.05);
  EXPECT_LT(spread.max, 1.5);
}

// Columns of boxes as seen from above; their areas from another grid than the roots'.
TEST_P(Roots, EqualAreasHaveEqualNumbers) {
  constexpr int boxes = 6, steps = 600;
  std::vector<double> area(boxes * boxes), count(boxes * boxes);
  const auto box_of = [](const Vector3d& p) {
    const auto along = [](double c, double r) {
      return std::min<std::size_t>(boxes - 1, static_cast<std::size_t>((c / r + 1) / 2 * boxes));
    };
    return boxes * along(p.x(), 0.0761) + along(p.y(), 0.0961);
  };
  double all = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double polar = M_PI * (i + 0.5) / steps, turn = 2 * M_PI * (k + 0.5) / steps;
      const Vector3d way(std::cos(polar), std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn));
      const Vector3d point = head_.surface_towards(way);
      if (!head_.has_hair(point)) continue;
      const double piece = std::sin(polar) * point.squaredNorm() / head_.surface_at(point).normal.dot(way);
      area[box_of(point)] += piece;
      all += piece;
    }
  for (const RootFrame& root : roots_) ++count[box_of(root.position)];
  for (std::size_t i = 0; i < area.size(); ++i) {
    const double expected = area[i] / all * GetParam();
    // A lattice's number differs by some of the points along its box's edge. Random points would differ by
    // the root of their number, several times as much in large boxes.
    EXPECT_NEAR(count[i], expected, 2 + 1.2 * std::pow(expected, 0.25) + 0.01 * expected) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, Roots, testing::Values(500, 20'000));

TEST(ScalpRoots, ASideChangesSmoothlyAlongTheScalp) {
  const EllipsoidHead head;
  const std::vector<RootFrame> roots = scalp_roots(head, 5000, 2);
  std::vector<Vector3d> points;
  for (const RootFrame& root : roots) points.push_back(root.position);
  const NearestPoints tree(points);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const auto found = tree.nearest(points[i], static_cast<long>(i));
    // Near the ears, 5 degrees away from the scalp, the side turns by 1 / sin(5 degrees) of the angle.
    EXPECT_LT((roots[i].side - roots[static_cast<std::size_t>(found.index)].side).norm(),
              found.distance / 0.076 / std::sin(5 * M_PI / 180) * 2);
  }
}

TEST(ScalpRoots, ASeedGivesTheSameAndAnotherOthers) {
  const EllipsoidHead head;
  const auto positions = [&](int count, std::uint64_t seed) {
    std::vector<Vector3d> points;
    for (const RootFrame& root : scalp_roots(head, count, seed)) points.push_back(root.position);
    return points;
  };
  EXPECT_EQ(positions(100, 1), positions(100, 1));
  EXPECT_NE(positions(100, 1), positions(100, 2));
  for (const int count : {0, 1, 2, 3, 7, 31})
    EXPECT_EQ(positions(count, 5).size(), static_cast<std::size_t>(count));
  EXPECT_THROW(scalp_roots(head, -1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace hair
