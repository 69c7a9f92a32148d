#include "hair/groom/groom_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hair/groom/nearest_points.h"
#include "hair/groom/resample.h"
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

// --- Other numbers of points

// Turns of a helix of radius 1, at `points` equal angles.
Eigen::VectorXd helix(int points, double turns) {
  Eigen::VectorXd x(3 * points);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * M_PI * turns * i / (points - 1);
    x.segment<3>(3 * i) = Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.1 * angle);
  }
  return x;
}

double length_of(const Eigen::VectorXd& x) {
  double length = 0;
  for (Eigen::Index k = 3; k < x.size(); k += 3) length += (x.segment<3>(k) - x.segment<3>(k - 3)).norm();
  return length;
}

TEST(Resample, PointsAtEqualDistancesStay) {
  for (const int points : {2, 3, 16, 100}) {
    const Eigen::VectorXd x = helix(points, 1.7);
    EXPECT_EQ(resampled(x, points), x) << points;
    EXPECT_EQ(resampled(resampled(x, 2 * points - 1), points), x) << points;
  }
}

TEST(Resample, EndsStayAndPointsLieOnTheLineAtEqualDistancesAlongIt) {
  Eigen::VectorXd x(12);
  x << 0.1, 0.2, 0.3, 1.1, 0.2, 0.3, 1.1, 3.2, 0.3, 1.1, 3.2, 4.3;  // 1, 3 and 4 long
  const Eigen::VectorXd y = resampled(x, 9);                        // 1 apart
  EXPECT_EQ(y.head<3>(), x.head<3>());
  EXPECT_EQ(y.tail<3>(), x.tail<3>());
  for (int i = 1; i < 9; ++i)
    // Coordinates of up to 5 have rounding of 5e-16 each.
    EXPECT_NEAR((y.segment<3>(3 * i) - y.segment<3>(3 * i - 3)).norm(), 1, 1e-14) << i;
  EXPECT_NEAR(length_of(y), length_of(x), 1e-13);
}

TEST(Resample, ACurveOfManyPointsLosesAChordsShareOfItsLength) {
  // A chord of a turn by the angle a is shorter by a^2 / 24 - a^4 / 1920; the rise is not shorter, and makes
  // the line longer by sqrt(1 + 0.01). The line of 1001 points has its own error.
  const Eigen::VectorXd x = helix(1001, 2);
  const double a = 4 * M_PI / 40, own = 4 * M_PI / 1000;
  EXPECT_NEAR(1 - length_of(resampled(x, 41)) / length_of(x), a * a / 24 / 1.01,
              a * a * a * a / 1920 + own * own / 24);
}

TEST(Resample, LinesWithoutLengthAndBaldRootsHaveAnAnswer) {
  EXPECT_EQ(resampled(Eigen::VectorXd::Ones(9), 5), Eigen::VectorXd::Ones(15));
  Groom groom{{Eigen::VectorXd::Ones(3), Eigen::VectorXd::LinSpaced(6, 0, 5)},
              {.thicknesses = {7, 1, 3}, .colours = {9, 9, 9, 0, 0, 0, 1, 1, 1}}};
  resample(groom, 3);
  EXPECT_EQ(groom.strands[0].size(), 3);
  EXPECT_EQ(groom.strands[1].size(), 9);
  EXPECT_EQ(groom.look.thicknesses, (std::vector<float>{7, 1, 2, 3}));
  EXPECT_EQ(groom.look.colours, (std::vector<float>{9, 9, 9, 0, 0, 0, 0.5F, 0.5F, 0.5F, 1, 1, 1}));
}

TEST(GroomEdit, StrandsKeepTheLookOfTheirPoints) {
  Groom groom{{Eigen::VectorXd::Ones(3), Eigen::VectorXd::Constant(6, 2), Eigen::VectorXd::Constant(6, 3)},
              {.thickness = 2, .thicknesses = {1, 2, 3, 4, 5}}};
  keep_every(groom, 2);
  EXPECT_EQ(groom.strands.size(), 2U);
  EXPECT_EQ(groom.look.thicknesses, (std::vector<float>{1, 4, 5}));
  scale(groom, 0.5);
  EXPECT_EQ(groom.strands[1], Eigen::VectorXd::Constant(6, 1.5));
  EXPECT_EQ(groom.look.thickness, 1);
  EXPECT_EQ(groom.look.thicknesses, (std::vector<float>{0.5F, 2, 2.5F}));
}

}  // namespace
}  // namespace hair
