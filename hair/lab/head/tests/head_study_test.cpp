// The study of a head with the reference's exercises: properties of its errors for any hair.
#include "hair/lab/head/head_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hair::head_study {
namespace {

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

}  // namespace
}  // namespace hair::head_study
