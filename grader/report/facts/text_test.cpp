// STAFF ONLY. Tests points in words.
#include "grader/report/facts/text.h"

#include <gtest/gtest.h>

namespace grader::inline report {
namespace {

TEST(ShownPoints, HaveTwoDecimalsAtMost) {
  EXPECT_EQ(shown_points(0), "0");
  EXPECT_EQ(shown_points(30), "30");
  EXPECT_EQ(shown_points(100), "100");
  EXPECT_EQ(shown_points(12.5), "12.5");
  EXPECT_EQ(shown_points(29.999999999999996), "30");
  EXPECT_EQ(shown_points(1.0 / 3), "0.33");
  EXPECT_EQ(shown_points(-1e-9), "0");
}

TEST(ShownTotal, HasNoZeroToReach) {
  EXPECT_EQ(shown_total(20, 200), "20 of 200 points");
  EXPECT_EQ(shown_total(15, 0), "15 points of extra credit");
}

}  // namespace
}  // namespace grader::report
