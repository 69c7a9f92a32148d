#include "hair/strand/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "hair/strand/make_strand.h"
#include "hair/strand/turns.h"
#include "hair/strand/variation.h"
#include "particles/gravity.h"

namespace hair {
namespace {

using Eigen::Quaterniond;

// An arc of a circle with radius 1, from its arc length 0 to 1.
Eigen::VectorXd arc(int segments) {
  Eigen::VectorXd x(3 * (segments + 1));
  for (int i = 0; i <= segments; ++i) {
    const double s = static_cast<double>(i) / segments;
    x.segment<3>(3 * i) = Eigen::Vector3d(std::cos(s), std::sin(s), 0);
  }
  return x;
}

Eigen::VectorXd evenly(int segments) {
  return Eigen::VectorXd::LinSpaced(segments + 1, 0, 1);
}

TEST(CentreLine, ItsOwnPointsComeBackBitForBit) {
  const Strand strand = uniform_strand({}, 30, 0.3);
  const Eigen::VectorXd x = arc(30), at = arc_lengths(strand);
  EXPECT_NEAR(at[30], 0.3, 1e-15);
  EXPECT_EQ(points_at(x, at, at), x);
  // A line with half of the points has every second one.
  const Eigen::VectorXd half = arc_lengths(uniform_strand({}, 15, 0.3));
  for (int i = 0; i <= 15; ++i) EXPECT_EQ(points_at(x, at, half).segment<3>(3 * i), x.segment<3>(6 * i)) << i;
}

TEST(CentreLine, BetweenPointsItIsOffByTheSagOfTheChord) {
  const Eigen::VectorXd wanted = Eigen::VectorXd::Constant(1, 0.5);
  for (const int segments : {5, 15, 45}) {  // odd: 0.5 is the middle of a segment
    const Eigen::Vector3d exact(std::cos(0.5), std::sin(0.5), 0);
    const Eigen::Vector3d found = points_at(arc(segments), evenly(segments), wanted);
    const double l = 1.0 / segments;
    EXPECT_NEAR((found - exact).norm(), 1 - std::cos(l / 2), 1e-15);
    EXPECT_LE((found - exact).norm(), l * l / 8);
  }
}

TEST(CentreLine, RefusesWhatIsNotOnTheLine) {
  const Eigen::VectorXd x = arc(4), at = evenly(4);
  for (const double s : {-0.01, 1.01, std::nan("")})
    EXPECT_THROW(points_at(x, at, Eigen::VectorXd::Constant(1, s)), std::invalid_argument) << s;
  EXPECT_THROW(points_at(x, evenly(3), at), std::invalid_argument);
}

constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

Vector3d some_direction(Variation& variation) {
  return Vector3d(variation.uniform(-1, 1), variation.uniform(-1, 1), variation.uniform(-1, 1)).normalized();
}

// The axis is perpendicular to both directions, so the angle is the smallest.
TEST(TurnBetween, TakesOneDirectionToTheOther) {
  Variation variation(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3d from = some_direction(variation), to = some_direction(variation);
    const double size = variation.uniform(0.1, 10);
    const Quaterniond turn = turn_between(size * from, to / size);
    // w^2 is half of 1 + cos: near half a turn its rounding error is relatively large.
    const double bound = 8 * kRounding / (1 + from.dot(to));
    EXPECT_LE((turn * from - to).norm(), bound);
    EXPECT_LE(std::abs(turn.norm() - 1), bound);
    EXPECT_LE(std::abs(turn.vec().dot(from)) + std::abs(turn.vec().dot(to)), bound);
  }
}

TEST(TurnBetween, OppositeDirectionsIsHalfATurn) {
  Variation variation(2);
  for (const double off : {0.0, 1e-9, 1e-7}) {
    const Vector3d from = some_direction(variation);
    const Vector3d to = -from + off * from.unitOrthogonal();
    const Quaterniond turn = turn_between(from, to);
    EXPECT_LE(std::abs(turn.norm() - 1), kRounding) << off;
    EXPECT_LE((turn * from - to).norm(), 2 * off + kRounding) << off;
  }
}

// Angles between 1e-3 and pi - 1e-3.
TEST(Turns, GoToVectorsAndBack) {
  Variation variation(3);
  for (int i = 0; i < 100; ++i) {
    const Vector3d angle = variation.uniform(1e-3, 3.14) * some_direction(variation);
    EXPECT_LE((turn_of(turn_by(angle)) - angle).norm(), 8 * kRounding);
  }
}

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
