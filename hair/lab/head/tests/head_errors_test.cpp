#include "hair/lab/head/head_errors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "solver/test_numbers.h"

namespace hair::head_study {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr int kPoints = 2, kStrands = 20;
using reference_tests::kUnit;

std::vector<double> still() {
  return std::vector<double>(3 * kPoints * kStrands, 0.25);
}

// Strand k is off by `by` at its second point.
void shift(std::vector<double>& points, int k, const Vector3d& by) {
  for (int axis = 0; axis < 3; ++axis) points[3 * (kPoints * k + 1) + axis] += by[axis];
}

// One of 20 strands may be farther off than `most`: strand k is off by k mm at one of two points, so that e_k
// = k mm / sqrt(2).
TEST(HeadErrors, AreRootMeanSquaresAndTheNinetyFifthPercentile) {
  std::vector<double> made = still();
  double squares = 0;
  for (int k = 0; k < kStrands; ++k) {
    shift(made, k, Vector3d(0, 1e-3 * k, 0));
    squares += 1e-6 * k * k;
  }
  HeadErrorTally tally(kPoints);
  tally.add(made, still(), Matrix3d::Identity());
  const HeadError start = tally.errors().start;
  // Coordinates of a quarter of a metre have an error of 2^-54 m, sums of 40 squares a relative one of 40
  // units.
  EXPECT_NEAR(start.rms, std::sqrt(squares / (kPoints * kStrands)), 100 * kUnit);
  EXPECT_NEAR(start.most, 18e-3 / std::sqrt(2.0), 100 * kUnit);
  EXPECT_EQ(tally.errors().end.rms, start.rms);
}

TEST(HeadErrors, OverTimeLeaveTheStartOut) {
  std::vector<double> near = still(), far = still();
  for (int k = 0; k < kStrands; ++k) shift(near, k, {3e-3, 0, 0}), shift(far, k, {0, 4e-3, 0});
  HeadErrorTally tally(kPoints);
  tally.add(far, still(), Matrix3d::Identity());
  tally.add(near, still(), Matrix3d::Identity());
  tally.add(still(), still(), Matrix3d::Identity());
  const HeadErrors errors = tally.errors();
  EXPECT_EQ(errors.end.rms, 0);
  EXPECT_EQ(errors.end.most, 0);
  EXPECT_NEAR(errors.all.rms, 3e-3 / 2, 100 * kUnit);  // 3 mm at half of the points, at half of the moments
  EXPECT_NEAR(errors.all.most, 3e-3 / std::sqrt(2.0), 100 * kUnit);
  // The differences from the start are 5 and 4 mm long. The start is kept in single precision.
  EXPECT_NEAR(errors.motion.rms, std::sqrt((25e-6 + 16e-6) / 4), 4e-3 * 0x1p-23);
  EXPECT_NEAR(errors.motion.most, 5e-3 / std::sqrt(2.0), 4e-3 * 0x1p-23);
}

// A difference that turns with the head is no error.
TEST(HeadErrors, OfTheMotionAloneAreNoneIfTheDifferenceTurnsWithTheHead) {
  const Matrix3d turn = Eigen::AngleAxisd(1.2, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<double> before = still(), after = still();
  for (int k = 0; k < kStrands; ++k) {
    const Vector3d by(1e-2 * k, 3e-2, -2e-2);
    shift(before, k, by);
    shift(after, k, turn * by);
  }
  HeadErrorTally tally(kPoints);
  tally.add(before, still(), Matrix3d::Identity());
  tally.add(after, still(), turn);
  EXPECT_LT(tally.errors().motion.rms, 0.2 * 0x1p-23);
  EXPECT_NEAR(tally.errors().all.rms, tally.errors().start.rms, 100 * kUnit);
}

}  // namespace
}  // namespace hair::head_study
