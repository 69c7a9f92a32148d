#include "hair/groom/groom_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hair/groom/nearest_points.h"
#include "hair/strand/variation.h"

namespace hair {
namespace {

std::vector<Eigen::Vector3d> random_points(int count, std::uint64_t seed) {
  Variation variation(seed);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(variation.uniform(-1, 1), variation.uniform(-1, 1), variation.uniform(0, 0.1));
  return points;
}

TEST(NearestPoints, IsTheOneThatALookAtAllFinds) {
  std::vector<Eigen::Vector3d> points = random_points(300, 1);
  points.insert(points.end(), 20, points[0]);  // at one place
  const NearestPoints tree(points);
  for (const Eigen::Vector3d& to : random_points(300, 2)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& point : points) least = std::min(least, (point - to).norm());
    const NearestPoints::Found found = tree.nearest(to);
    EXPECT_EQ(found.distance, least);
    EXPECT_EQ((points[static_cast<std::size_t>(found.index)] - to).norm(), least);
  }
  EXPECT_EQ(tree.nearest(points[0], 0).distance, 0);
  EXPECT_NE(tree.nearest(points[0], 0).index, 0);
  EXPECT_GT(tree.nearest(points[5], 5).distance, 0);
  EXPECT_EQ(NearestPoints({}).nearest(points[0]).index, -1);
  EXPECT_EQ(NearestPoints({points[0]}).nearest(points[0], 0).index, -1);
}

TEST(GroomMeasures, ACircleHasItsCurvatureAndALineNone) {
  Eigen::VectorXd circle(3 * 11);
  for (int i = 0; i < 11; ++i)
    circle.segment<3>(3 * i) = 4 * Eigen::Vector3d(std::cos(0.2 * i * i / 10), std::sin(0.2 * i * i / 10), 0);
  const GroomMeasures measures = measure_groom({{circle}});
  EXPECT_NEAR(measures.curvature.min, 0.25, 1e-13);
  EXPECT_NEAR(measures.curvature.max, 0.25, 1e-13);
  // The angle between the middles of arcs of angle 0.02 (2 i + 1).
  EXPECT_NEAR(measures.bend.max, (0.19 + 0.17) / 1 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(measures.length.max, 4 * 2, 4 * 2 * 0.38 * 0.38 / 24);
  EXPECT_EQ(measure_groom({{Eigen::VectorXd::LinSpaced(9, 0, 8)}}).curvature.max, 0);
}

TEST(GroomMeasures, SpreadsAreOfTheNumbers) {
  const Spread spread = spread_of({5, 1, 4, 2, 3, 6, 7, 8, 9, 10, 11});
  EXPECT_EQ(spread.min, 1);
  EXPECT_EQ(spread.median, 6);
  EXPECT_EQ(spread.mean, 6);
  EXPECT_EQ(spread.most, 10);
  EXPECT_EQ(spread.max, 11);
  EXPECT_EQ(spread_of({}).max, 0);
}

// A brush of straight strands of two segments, 1 apart.
Groom brush() {
  Groom groom;
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 10; ++k)
      groom.strands.emplace_back((Eigen::VectorXd(9) << i, k, 0, i, k, 1, i, k, 2).finished());
  return groom;
}

std::string oddities(const Groom& groom) {
  std::string all;
  for (const Oddity& one : measure_groom(groom).odd)
    all += std::to_string(one.count) + " " + one.what + " (" + std::to_string(one.strand) + ")\n";
  return all;
}

TEST(GroomMeasures, WhatIsOddIsNamed) {
  EXPECT_EQ(oddities(brush()), "");
  EXPECT_NEAR(measure_groom(brush()).unit_guess, 0.2 / 9, 1e-15);
  const auto with = [](std::size_t strand, const Eigen::VectorXd& x) {
    Groom groom = brush();
    groom.strands[strand] = x;
    return oddities(groom);
  };
  const auto x = [](std::initializer_list<double> numbers) {
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(numbers.begin(), static_cast<Eigen::Index>(numbers.size())));
  };
  EXPECT_EQ(with(2, x({0, 2, NAN, 1, 2, 3})),
            "1 strand with a number that is not finite; no program can use it (2)\n");
  EXPECT_EQ(with(3, x({0, 3, 0})), "1 bald root: a strand of a single point (3)\n");
  EXPECT_EQ(with(4, x({0, 4, 0, 0, 4, 0})),
            "1 strand without length (4)\n1 point where the point before is; scenes refuse it (4)\n");
  EXPECT_EQ(with(6, x({0, 6, 0, 0, 6, 1, 0, 6, 0.5})),
            "1 joint that bends by more than 154 degrees; scenes refuse it (6)\n");
}

}  // namespace
}  // namespace hair
