#include "hair/live/hand.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hair {
namespace {

TEST(Hand, ReachesItsGoalAndIsNeverTooFast) {
  const Vector3d pivot(0, 0, 1), tip(0.2, 0, 1), goal(1, 0, -0.5);
  for (const double h : {1.0 / 30, 1.0 / 240, 1.0 / 3840}) {
    Hand hand(pivot);
    EXPECT_EQ(hand.after(h)(tip), tip);
    hand.go_to(goal, M_PI / 2);
    Vector3d middle = pivot;
    Way way;
    for (double t = 0; t < 2; t += h) {
      way = hand.after(h);
      EXPECT_LE((way(pivot) - middle).norm(), (1 + 1e-12) * kFastestHand * h);
      middle = way(pivot);
    }
    EXPECT_NEAR((way(pivot) - pivot - goal).norm(), 0, 1e-6) << h;
    EXPECT_NEAR((way(tip) - (pivot + goal + Vector3d(0, 0.2, 0))).norm(), 0, 1e-6) << "a quarter turn";
  }
}

}  // namespace
}  // namespace hair
