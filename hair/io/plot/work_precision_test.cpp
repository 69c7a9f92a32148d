#include "hair/io/plot/work_precision.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hair {
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

TEST(TimeRatio, IsTheFactorOfTimesWhereverTheSamplesLie) {
  EXPECT_EQ(time_ratio(curve(2, 1e-9), curve(2, 1e-9), 1e-15), 1.0);
  // Twice the time for each error: at the same step sizes, and between them.
  std::vector<Sample> slow = curve(2, 1e-9);
  for (Sample& sample : slow) sample.seconds *= 2;
  EXPECT_NEAR(*time_ratio(slow, curve(2, 1e-9), 1e-15), 2, 1e-12);
  EXPECT_NEAR(*time_ratio(slow, curve(2, 1e-9, 1.3e-3), 1e-15), 2, 1e-12);
  EXPECT_NEAR(*time_ratio(curve(2, 1e-9, 1.3e-3), slow, 1e-15), 0.5, 1e-12);
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
  // Both reach the least error with their first sample; the other samples are rounding.
  std::vector<Sample> one = curve(1, 1e-6), two = curve(1, 1e-6);
  for (std::size_t k = 1; k < one.size(); ++k) {
    one[k].error *= 1e-3;
    two[k].error *= 1e-6;
  }
  EXPECT_NEAR(*time_ratio(one, two, one[0].error), 1, 1e-12);
}

TEST(TimeFor, IsBetweenTheRunsAndNoneWhereNoRunGets) {
  const std::vector<Sample> samples = curve(2, 1e-9);  // errors from 1e-3 down to 1e-3 / 4^5
  EXPECT_NEAR(*time_for(samples, 1e-3, 1e-15), 1e-3, 1e-12);
  EXPECT_NEAR(*time_for(samples, 1e-3 / 9, 1e-15), 3e-3, 1e-12);
  EXPECT_NEAR(*time_for(samples, 1, 1e-15), 1e-3, 1e-12) << "no run takes less";
  EXPECT_FALSE(time_for(samples, 1e-3 / 1025, 1e-15));
  EXPECT_FALSE(time_for({}, 1, 1e-15));
}

TEST(Stalls, AfterThreeHalvingsThatGainNothing) {
  EXPECT_FALSE(stalls({1, 1, 1}));
  EXPECT_TRUE(stalls({4, 1, 0.99, 1, 0.99}));
  EXPECT_FALSE(stalls({1, 1, 1, 0.9}));
  EXPECT_FALSE(stalls({1, NAN, 1, 1}));
}

TEST(Level, IsAsWideAsThePoints) {
  Figure figure;
  add_level(figure, "known", 1);
  EXPECT_TRUE(figure.series.empty());
  figure.series = {{"a", {{2, 1}, {8, 1}}}, {"b", {{1, 1}}}};
  add_level(figure, "known", 0.5);
  const std::vector<Point>& line = figure.series.back().points;
  EXPECT_EQ(line[0].x, 1);
  EXPECT_EQ(line[1].x, 8);
  EXPECT_EQ(line[1].y, 0.5);
}

}  // namespace
}  // namespace hair
