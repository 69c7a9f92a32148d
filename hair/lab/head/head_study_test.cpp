// The study of a head with the reference's exercises: properties of its errors for any hair.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "hair/lab/head/head_errors.h"
#include "hair/lab/head/head_study.h"
#include "solver/test_numbers.h"

namespace hair::head_study {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

const std::atomic<bool> kNever = false;
void say_nothing(const std::string&) {}

const HeadHair& hair_named(const std::string& id) {
  return *std::find_if(head_hairs().begin(), head_hairs().end(),
                       [&](const HeadHair& one) { return one.id == id; });
}

HeadCase studied(const GrownHead& head, const HeadStudySettings& settings, const SeeHead& see = nullptr) {
  return *study_head(std::make_shared<Bust>(), head, settings, kNever, say_nothing, see);
}

// Straight strands of eight points on a level square of 10 cm, side x side of them. They leave it in
// directions that turn smoothly along it, and there are no obstacles: a strand's motion is a smooth
// function of its root.
GrownHead smooth_patch(int side) {
  static const HeadHair hair = {"patch", "A patch", *find_hair_style("long-smooth"), 8, false};
  GrownHead head{&hair, {}, {}, 0.14};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double u = i / (side - 1.0) - 0.5, v = j / (side - 1.0) - 0.5;
      const Vector3d root(0.1 * u, 0.1 * v, 0);
      const Vector3d way = Vector3d(std::sin(2 * u + v), std::sin(2 * v), 1 + u * v).normalized();
      head.roots.push_back({root, Vector3d::UnitZ(), Vector3d::UnitX()});
      Eigen::VectorXd x(3 * hair.points);
      for (int k = 0; k < hair.points; ++k) x.segment<3>(3 * k) = root + 0.02 * k * way;
      head.strands.push_back(x);
    }
  return head;
}

class Hairs : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(HeadStudy, Hairs, testing::Values("straight", "wavy", "curly"),
                         [](const auto& one) { return std::string(one.param); });

// A child at a guide's root has this guide's weight 1 to 1e-8: root_weights finds its place to 1e-10 of a
// triangle's edge, which is at most a hundred times the triangle's height. The rest comes from guides that
// lie at most two lengths away.
TEST_P(Hairs, HaveNoErrorIfEachIsAGuide) {
  const GrownHead head = grow_head(Bust(), hair_named(GetParam()), 4);
  const HeadCase one = studied(head, {true, {4}});
  ASSERT_EQ(one.runs.size(), 1u);
  EXPECT_EQ(one.runs[0].guides, 4);
  for (const ModeRun& mode : one.runs[0].modes)
    for (const HeadError& error : {mode.errors.start, mode.errors.end, mode.errors.all, mode.errors.motion}) {
      EXPECT_LE(error.rms, 2e-8 * head.length);
      EXPECT_LE(error.most, 2e-8 * head.length);
    }
}

// If n guides are chosen farthest first, each root is within twice the least possible distance, which falls
// as the root of n. So sixteen times the guides are at most half as far away. Interpolation between them has
// an error of second order in this distance, and of first order at the rim, where there is no triangle: it
// falls to a half at least. Extrapolation keeps the shape of the nearest guide: first order.
TEST(HeadStudy, ErrorsOfSmoothHairFallWithMoreGuides) {
  const HeadCase one = studied(smooth_patch(13), {false, {4, 64}});
  ASSERT_EQ(one.runs.size(), 2u);
  for (std::size_t m = 0; m < kModes.size(); ++m) {
    const HeadErrors &few = one.runs[0].modes[m].errors, &many = one.runs[1].modes[m].errors;
    EXPECT_GT(few.all.rms, 1e-3) << kModes[m].id;
    EXPECT_LE(many.start.rms, few.start.rms / 2) << kModes[m].id;
    EXPECT_LE(many.end.rms, few.end.rms / 2) << kModes[m].id;
    EXPECT_LE(many.all.rms, few.all.rms / 2) << kModes[m].id;
    EXPECT_LE(many.all.most, few.all.most / 2) << kModes[m].id;
  }
}

TEST(HeadStudy, SeesEveryStrandFirstAndThenEachNumberOfGuidesOnce) {
  const GrownHead head = grow_head(Bust(), hair_named("straight"), 8);
  std::vector<int> seen;
  studied(head, {true, {2, 4, 9}}, [&](int guides, std::span<const double> points) {
    seen.push_back(guides);
    EXPECT_EQ(points.size(), 3u * 8 * head.hair->points);
  });
  EXPECT_EQ(seen, (std::vector<int>{8, 2, 4}));  // 9 guides of 8 strands are left out
}

TEST(HeadStudy, StopsIfInterrupted) {
  const std::atomic<bool> now = true;
  const GrownHead head = grow_head(Bust(), hair_named("straight"), 4);
  EXPECT_FALSE(study_head(std::make_shared<Bust>(), head, {true, {2}}, now, say_nothing, nullptr));
}

TEST(HeadHair, AllAlikeHasOneLength) {
  const GrownHead head = grow_head(Bust(), hair_named("combed"), 50);
  for (const Eigen::VectorXd& x : head.strands) {
    double length = 0;
    for (Eigen::Index k = 3; k < x.size(); k += 3) length += (x.segment<3>(k) - x.segment<3>(k - 3)).norm();
    // Chords of a line of one length, 36 cm, that bends by two right angles at most, over 24 pieces.
    EXPECT_NEAR(length, 0.36, 0.36 * 0.02);
  }
}

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
