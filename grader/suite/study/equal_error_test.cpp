// STAFF ONLY.
#include "grader/suite/study/equal_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace grader {
namespace {

// error = size / time^order, at some times.
std::vector<Sample> curve(double order, double size, double first = 1e-3, int count = 6) {
  std::vector<Sample> samples;
  for (int k = 0; k < count; ++k) {
    const double time = first * std::pow(2, k);
    samples.push_back({time, size * std::pow(time, -order)});
  }
  return samples;
}

TEST(TimeRatio, IsOneOfACurveToItself) {
  EXPECT_EQ(time_ratio(curve(2, 1e-9), curve(2, 1e-9), 1e-15), 1.0);
}

TEST(TimeRatio, IsTheFactorOfTimesWhereverTheSamplesLie) {
  // Twice the time for each error: at the same step sizes, and between them.
  std::vector<Sample> slow = curve(2, 1e-9);
  for (Sample& sample : slow) sample.seconds *= 2;
  EXPECT_NEAR(*time_ratio(slow, curve(2, 1e-9), 1e-15), 2, 1e-12);
  EXPECT_NEAR(*time_ratio(slow, curve(2, 1e-9, 1.3e-3), 1e-15), 2, 1e-12);
  EXPECT_NEAR(*time_ratio(curve(2, 1e-9, 1.3e-3), slow, 1e-15), 0.5, 1e-12);
}

TEST(TimeRatio, CountsALargerErrorAsTheStepsThatItCosts) {
  // Four times the error at the same time: order 1 needs four times the steps, order 2 twice.
  EXPECT_NEAR(*time_ratio(curve(1, 4e-6), curve(1, 1e-6), 1e-15), 4, 1e-12);
  EXPECT_NEAR(*time_ratio(curve(2, 4e-9), curve(2, 1e-9), 1e-15), 2, 1e-12);
}

TEST(TimeRatio, IsNoneWhereNoErrorIsReachedByBoth) {
  EXPECT_FALSE(time_ratio(curve(1, 1), curve(1, 1e-6), 1e-15));
  EXPECT_FALSE(time_ratio({}, curve(1, 1), 1e-15));
  EXPECT_FALSE(time_ratio(curve(1, 1), {}, 1e-15));
}

TEST(TimeRatio, LeavesOutWhatIsBeatenInBoth) {
  std::vector<Sample> bumpy = curve(1, 1e-6);
  bumpy.push_back({1, 1});  // slower than all, and worse
  EXPECT_NEAR(*time_ratio(bumpy, curve(1, 1e-6), 1e-15), 1, 1e-12);
}

TEST(TimeRatio, TakesNoNoteOfWhatIsBelowTheLeastError) {
  // Both reach the least error with their first sample; what the others have is rounding.
  std::vector<Sample> one = curve(1, 1e-6), two = curve(1, 1e-6);
  for (std::size_t k = 1; k < one.size(); ++k) {
    one[k].error *= 1e-3;
    two[k].error *= 1e-6;
  }
  EXPECT_NEAR(*time_ratio(one, two, one[0].error), 1, 1e-12);
}

}  // namespace
}  // namespace grader
