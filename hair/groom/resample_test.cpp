#include "hair/groom/resample.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/groom/groom_edit.h"

namespace hair {
namespace {

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
