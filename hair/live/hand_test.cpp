#include "hair/live/hand.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hair {
namespace {

TEST(Hand, ReachesItsGoalAndIsNeverTooFast) {
  const Vector3d pivot(0, 0, 1), tip(kHandReach, 0, 1);
  for (const Vector3d& goal : {Vector3d(1, 0, -0.5), Vector3d(0, 0, 0)})  // the second one only turns
    for (const double h : {1.0 / 30, 1.0 / 240, 1.0 / 3840}) {
      Hand hand(pivot);
      EXPECT_EQ(hand.after(h)(tip), tip);
      hand.go_to(goal, M_PI / 2);
      hand.go_to(Vector3d(NAN, 0, 0), 1e300);  // is ignored
      Way way, before{Eigen::Quaterniond::Identity(), pivot, pivot};
      for (double t = 0; t < 2; t += h, before = way) {
        way = hand.after(h);
        EXPECT_LE((way(pivot) - before(pivot)).norm(), (1 + 1e-12) * kFastestHand * h);
        // It moves and turns; each has its part of the speed, and the tip has both.
        EXPECT_LE((way(tip) - before(tip)).norm(), std::sqrt(2) * kFastestHand * h);
      }
      EXPECT_NEAR((way(pivot) - pivot - goal).norm(), 0, 1e-6) << h;
      EXPECT_NEAR((way(tip) - (pivot + goal + Vector3d(0, kHandReach, 0))).norm(), 0, 1e-6) << "a quarter";
    }
}

}  // namespace
}  // namespace hair
