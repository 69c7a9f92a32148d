#include "hair/strand/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hair/strand/make_strand.h"
#include "particles/gravity.h"

namespace hair {
namespace {

Eigen::VectorXd line(double first, double second) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(9);
  x[5] = -first;
  x[8] = -first - second;
  return x;
}

TEST(Measures, StretchIsTheWorstSegmentsInEitherDirection) {
  const Strand strand = strand_from_rest({}, line(1, 2));
  EXPECT_EQ(largest_stretch(strand, line(1, 2)), 0);
  EXPECT_DOUBLE_EQ(largest_stretch(strand, line(1.25, 2)), 0.25);
  EXPECT_DOUBLE_EQ(largest_stretch(strand, line(1.25, 0.5)), 0.75);  // compressed
  EXPECT_EQ(largest_stretch(strand, line(0, 2)), 1);
  EXPECT_TRUE(std::isnan(largest_stretch(strand, line(std::numeric_limits<double>::quiet_NaN(), 2))));
  EXPECT_EQ(largest_stretch(strand_from_rest({}, Eigen::VectorXd::Zero(3)), Eigen::VectorXd::Zero(3)), 0);
}

TEST(Measures, EnergyAndMomentaAreSumsOverTheParticles) {
  const Strand strand = strand_from_rest({}, line(1, 2));
  const particles::Particles particles{strand.mass, {1, 0, 0}};
  particles::State state{line(1, 2) + Eigen::Vector3d(5, 6, 7).replicate(3, 1), Eigen::VectorXd::Zero(9)};
  state.v[6] = 3;  // the tip, 3 m below the root
  const particles::Gravity gravity(strand.mass, Eigen::Vector3d(0, 0, -10));
  const Measures measures = measure(strand, particles, gravity, state);
  const double tip = strand.mass[2];
  EXPECT_DOUBLE_EQ(measures.kinetic, tip * 9 / 2);
  EXPECT_DOUBLE_EQ(measures.potential, 10 * (strand.mass[0] * 7 + strand.mass[1] * 6 + tip * 4));
  EXPECT_DOUBLE_EQ(measures.energy(), measures.kinetic + measures.potential);
  EXPECT_DOUBLE_EQ(measures.momentum[0], 3 * tip);
  EXPECT_DOUBLE_EQ(measures.angular_momentum[1], -9 * tip);  // (0, 0, -3) x (3, 0, 0)
}

// A turn about the root stretches nothing; a growth by 3 / s stretches all segments by that, for any length.
TEST(Measures, TheStretchRateIsThatOfTheLargestGrowth) {
  Strand strand;
  strand.mass = Eigen::VectorXd::Ones(3);
  strand.rest_length = Eigen::Vector2d(1, 2);
  Eigen::VectorXd x(9), turn(9);
  x << 0, 0, 0, 0, 1, 0, 2, 1, 0;
  turn << 0, 0, 0, -5, 0, 0, -5, 10, 0;
  EXPECT_EQ(largest_stretch_rate(strand, x, turn), 0);
  EXPECT_EQ(largest_stretch_rate(strand, x, turn + 3 * x), 3);
  x.segment<3>(3).setZero();  // has no direction then
  EXPECT_EQ(largest_stretch_rate(strand, x, Eigen::VectorXd::Zero(9)), 0);
  turn[8] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(largest_stretch_rate(strand, x, turn)));
}

}  // namespace
}  // namespace hair
