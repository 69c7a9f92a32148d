#include "hair/strand/turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hair/strand/variation.h"

namespace hair {
namespace {

using Eigen::Quaterniond;

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

}  // namespace
}  // namespace hair
