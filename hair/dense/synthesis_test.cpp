// STAFF ONLY. Tests the synthesis of dense hair from guides.
#include "hair/dense/synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hair/dense/test_guides.h"
#include "solver/test_allocations.h"

namespace reference_tests {
namespace {

using hair::Parents, hair::Plane, hair::Synthesis, hair::SynthesisCounts, hair::SynthesisDescription,
    hair::SynthesisMode;

constexpr int kPoints = 12;
constexpr SynthesisMode kModes[] = {SynthesisMode::interpolate, SynthesisMode::extrapolate,
                                    SynthesisMode::blend};

SynthesisDescription head(SynthesisMode mode, int guides = 150, int children = 2000) {
  return {.guides = roots_on_ball(guides, 0.1, 2),
          .children = roots_on_ball(children, 0.1, 2),
          .points = kPoints,
          .mode = mode,
          .spread = 1.5,
          .jitter = 0.3,
          .length = 0.1,
          .seed = 3};
}

VectorXd head_guides(const SynthesisDescription& description) {
  return curls(description.guides, kPoints, 0.004, 0.02);
}

Vector3d point_of(const std::vector<double>& strands, std::size_t i) {
  return Eigen::Map<const Vector3d>(strands.data() + 3 * i);
}

TEST(Synthesis, WeightsAreThoseOfThePlaceBetweenGuides) {
  Synthesis synthesis({.guides = roots_on_disc(80, 0.1), .children = roots_on_disc(1000, 0.08)});
  const std::vector<RootFrame> guides = roots_on_disc(80, 0.1), children = roots_on_disc(1000, 0.08);
  for (int child = 0; child < 1000; ++child) {
    const Parents& parents = synthesis.parents(child);
    Vector3d mean = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) mean += parents.weights[k] * guides[parents.guides[k]].position;
    EXPECT_LE((mean - children[child].position).norm(), 1e-14) << "child " << child;
    const auto distance = [&](int k) {
      return (guides[parents.guides[k]].position - children[child].position).norm();
    };
    EXPECT_LE(distance(0), std::min(distance(1), distance(2))) << "the nearest comes first; child " << child;
  }
}

TEST(Synthesis, EveryChildStartsAtItsOwnRoot) {
  for (const SynthesisMode mode : kModes) {
    const SynthesisDescription description = head(mode);
    Synthesis synthesis(description);
    const std::vector<double> strands = make_all(synthesis, head_guides(description));
    for (std::size_t child = 0; child < description.children.size(); ++child)
      EXPECT_LE((point_of(strands, child * kPoints) - description.children[child].position).norm(), 1e-15);
  }
}

TEST(Synthesis, AChildWhereAGuideGrowsIsTheGuide) {
  for (const SynthesisMode mode : kModes) {
    SynthesisDescription description = head(mode);
    description.children = description.guides;
    description.length = 0;
    Synthesis synthesis(description);
    const VectorXd guides = head_guides(description);
    const std::vector<double> strands = make_all(synthesis, guides);
    for (Eigen::Index i = 0; i < guides.size(); ++i) EXPECT_NEAR(strands[i], guides[i], 1e-14);
  }
}

TEST(Synthesis, MovesWithTheHead) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Vector3d way(0.5, -1, 2);
  for (const SynthesisMode mode : kModes) {
    const SynthesisDescription description = head(mode);
    Synthesis synthesis(description);
    VectorXd guides = head_guides(description);
    const std::vector<double> before = make_all(synthesis, guides);
    for (Eigen::Index at = 0; at < guides.size(); at += 3)
      guides.segment<3>(at) = turn * guides.segment<3>(at) + way;
    const std::vector<double> after = make_all(synthesis, guides, turn);
    for (std::size_t i = 0; i < before.size() / 3; ++i)
      ASSERT_LE((point_of(after, i) - (turn * point_of(before, i) + way)).norm(), 1e-13) << "point " << i;
  }
}

TEST(Synthesis, HasTheSameBitsWithAnyThreads) {
  for (const SynthesisMode mode : kModes) {
    const SynthesisDescription description = head(mode);
    Synthesis one(description, 1), three(description, 3);
    EXPECT_EQ(make_all(one, head_guides(description)), make_all(three, head_guides(description)));
  }
}

TEST(Synthesis, OtherSeedsGiveOtherHairAndTheSameSeedTheSame) {
  SynthesisDescription description = head(SynthesisMode::blend);
  Synthesis one(description), same(description);
  description.seed = 4;
  Synthesis other(description);
  const VectorXd guides = head_guides(description);
  EXPECT_EQ(make_all(one, guides), make_all(same, guides));
  EXPECT_NE(make_all(one, guides), make_all(other, guides));
}

TEST(Synthesis, AFrameAllocatesNothing) {
  const std::vector<Plane> view = {{Vector3d::Zero(), Vector3d(1, 0, 0)}};
  for (const SynthesisMode mode : kModes) {
    const SynthesisDescription description = head(mode);
    Synthesis synthesis(description, 2);
    const VectorXd guides = head_guides(description);
    std::vector<double> strands(3 * kPoints * description.children.size());
    const long before = allocations();
    synthesis.make({guides.data(), static_cast<std::size_t>(guides.size())}, Eigen::Matrix3d::Identity(),
                   view, std::span<double>(strands));
    EXPECT_EQ(allocations() - before, 0);
  }
}

// Strands of a clump end nearer to each other than they begin; if guides are straight and parallel, a tip
// moves by the part `gathered` towards a common one.
TEST(Synthesis, ClumpsGatherTips) {
  SynthesisDescription description{
      .guides = roots_on_disc(80, 0.1), .children = roots_on_disc(1000, 0.08), .points = kPoints};
  VectorXd guides(3 * kPoints * 80);
  for (int guide = 0; guide < 80; ++guide)
    for (int i = 0; i < kPoints; ++i)
      guides.segment<3>(3 * (kPoints * guide + i)) =
          description.guides[guide].position + Vector3d(0, 0, 0.01 * i);
  Synthesis loose(description);
  const std::vector<double> before = make_all(loose, guides);
  description.clump = 25;
  description.gathered = 1;
  Synthesis clumped(description);
  const std::vector<double> after = make_all(clumped, guides);
  std::vector<std::array<double, 2>> tips;
  for (std::size_t child = 0; child < 1000; ++child) {
    EXPECT_EQ(point_of(after, child * kPoints), point_of(before, child * kPoints)) << "roots stay";
    const Vector3d tip = point_of(after, child * kPoints + kPoints - 1);
    tips.push_back({std::round(1e9 * tip[0]), std::round(1e9 * tip[1])});
  }
  std::sort(tips.begin(), tips.end());
  const auto places = std::unique(tips.begin(), tips.end()) - tips.begin();
  // The expected number is 40, with 6 standard deviations of its square root.
  EXPECT_NEAR(static_cast<double>(places), 40, 38);
}

// About the requested part of the strands are fly-aways, and no others.
TEST(Synthesis, FlyAwaysAreFew) {
  SynthesisDescription description = head(SynthesisMode::blend);
  const VectorXd guides = head_guides(description);
  Synthesis none(description);
  description.fly_aways = 0.1;
  Synthesis some(description);
  const std::vector<double> before = make_all(none, guides), after = make_all(some, guides);
  int moved = 0;
  for (std::size_t child = 0; child < 2000; ++child)
    moved +=
        point_of(after, child * kPoints + kPoints - 1) != point_of(before, child * kPoints + kPoints - 1);
  // 200 of 2000, with a standard deviation of 13.4: six of them.
  EXPECT_NEAR(moved, 200, 81);
}

// No child with a point in view is left out, and the view does not change the children in it.
TEST(Synthesis, LeavesOutWhatIsOutOfView) {
  const std::vector<Plane> view = {{Vector3d(0.05, 0, 0), Vector3d(1, 0, 0)},
                                   {Vector3d(0, 0, 0.02), Vector3d(0, 0.6, 0.8)}};
  for (const SynthesisMode mode : kModes) {
    SynthesisDescription description = head(mode);
    description.clump = 30;
    description.gathered = 0.5;
    description.fly_aways = 0.1;
    Synthesis synthesis(description);
    const VectorXd guides = head_guides(description);
    const std::vector<double> all = make_all(synthesis, guides);
    std::vector<double> some(all.size());
    const SynthesisCounts counts = synthesis.make({guides.data(), static_cast<std::size_t>(guides.size())},
                                                  Eigen::Matrix3d::Identity(), view, std::span<double>(some));
    const std::span<const int> in_view = synthesis.in_view();
    EXPECT_EQ(counts.children, static_cast<int>(in_view.size()));
    EXPECT_EQ(counts.children + counts.children_out_of_view, 2000);
    EXPECT_GT(counts.children_out_of_view, 1000);
    EXPECT_EQ(counts.guides_used + counts.guides_idle, 150);
    EXPECT_GT(counts.guides_idle, 50);
    std::vector<char> needed(150, 0);
    std::size_t next = 0;
    for (int child = 0; child < 2000; ++child) {
      bool seen = false;
      for (int i = 0; i < kPoints; ++i) {
        const Vector3d x =
            point_of(all, static_cast<std::size_t>(child) * kPoints + static_cast<std::size_t>(i));
        seen = seen || std::all_of(view.begin(), view.end(), [&](const Plane& plane) {
                 return plane.normal.dot(x - plane.point) >= 0;
               });
      }
      const bool there = next < in_view.size() && in_view[next] == child;
      EXPECT_TRUE(there || !seen) << "child " << child;
      if (!there) continue;
      EXPECT_TRUE(std::equal(some.begin() + static_cast<long>(3 * kPoints * next),
                             some.begin() + static_cast<long>(3 * kPoints * (next + 1)),
                             all.begin() + 3 * kPoints * child));
      ++next;
      const Parents& parents = synthesis.parents(child);
      for (int k = 0; k < (mode == SynthesisMode::extrapolate ? 1 : 3); ++k)
        if (k == 0 || parents.weights[k] > 0) needed[parents.guides[k]] = 1;
    }
    EXPECT_EQ(next, in_view.size());
    EXPECT_EQ(counts.guides_used, std::count(needed.begin(), needed.end(), 1));
  }
}

TEST(Synthesis, OfGuidesOnALineAndOfOne) {
  std::vector<RootFrame> line, children;
  for (int i = 0; i < 5; ++i)
    line.push_back({Vector3d(0.01 * ((2 * i) % 5), 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)});
  for (int i = 0; i <= 40; ++i)
    children.push_back({Vector3d(0.001 * i, 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)});
  const Synthesis synthesis({.guides = line, .children = children});
  for (int child = 0; child <= 40; ++child) {
    const Parents& parents = synthesis.parents(child);
    double mean = 0;
    for (int k = 0; k < 3; ++k) {
      mean += parents.weights[k] * line[parents.guides[k]].position.x();
      EXPECT_LE(std::abs(line[parents.guides[k]].position.x() - 0.001 * child), 0.01 + 1e-12);
    }
    EXPECT_NEAR(mean, 0.001 * child, 1e-12);
  }
  const Synthesis alone({.guides = {line[0]}, .children = children});
  EXPECT_NEAR(alone.parents(7).weights[0] + alone.parents(7).weights[1] + alone.parents(7).weights[2], 1,
              1e-12);
}

TEST(Synthesis, SaysWhatItCanNotTake) {
  EXPECT_THROW(Synthesis({.guides = {}}), std::invalid_argument);
  EXPECT_THROW(Synthesis({.guides = roots_on_disc(3, 1), .points = 1}), std::invalid_argument);
  EXPECT_THROW(Synthesis({.guides = roots_on_disc(3, 1)}, 0), std::invalid_argument);
  EXPECT_THROW(Synthesis({.guides = {{Vector3d(0, std::nan(""), 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)}}}),
               std::invalid_argument);
  Synthesis synthesis({.guides = roots_on_disc(3, 1), .children = roots_on_disc(10, 1), .points = 4});
  std::vector<double> guides(36, 0.0), strands(119);
  EXPECT_THROW(synthesis.make(guides, Eigen::Matrix3d::Identity(), {}, std::span<double>(strands)),
               std::invalid_argument);
  EXPECT_THROW(
      synthesis.make({guides.data(), 35}, Eigen::Matrix3d::Identity(), {}, std::span<double>(strands)),
      std::invalid_argument);
}

// Near neighbours have nearly the same side, up to the pole's opposite.
TEST(SideAlongScalp, DoesNotJump) {
  const Vector3d pole(0, 0.6, 0.8);
  for (const RootFrame& root : roots_on_ball(500, 1, 2.5)) {
    const Vector3d other = (root.axis + 1e-4 * Vector3d(1, 1, 1)).normalized();
    if (std::acos(root.axis.dot(pole)) > 2.6) continue;
    EXPECT_LE((hair::side_along_scalp(pole, root.axis) - hair::side_along_scalp(pole, other)).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace reference_tests
