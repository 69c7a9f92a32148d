#include "hair/head/grow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "hair/groom/groom_measures.h"
#include "hair/groom/nearest_points.h"
#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/grow_line.h"
#include "hair/head/scalp_roots.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

enum class Which { ellipsoid, bust };

std::unique_ptr<Head> made_head(Which which) {
  if (which == Which::ellipsoid) return std::make_unique<EllipsoidHead>();
  return std::make_unique<Bust>();
}

class Styles : public testing::TestWithParam<std::tuple<const char*, Which>> {
 protected:
  const HairStyle& style_ = *find_hair_style(std::get<0>(GetParam()));
  const Which which_ = std::get<1>(GetParam());
  const std::unique_ptr<Head> made_ = made_head(which_);
  const Head& head_ = *made_;
};

double deepest(const Head& head, const Groom& groom) {
  double least = 1;
  for (const Eigen::VectorXd& x : groom.strands)
    for (Eigen::Index k = 0; k + 3 < x.size(); k += 3)
      for (int i = 1; i <= 16; ++i)
        least = std::min(
            least,
            head.surface_at(x.segment<3>(k) + i / 16.0 * (x.segment<3>(k + 3) - x.segment<3>(k))).distance);
  return least;
}

TEST_P(Styles, NoStrandIsInsideTheHead) {
  for (const int points : {0, fewest_points(style_)}) {
    const Groom groom =
        grow_groom(head_, style_, {.strands = which_ == Which::bust ? 100 : 2000, .points = points});
    EXPECT_GE(deepest(head_, groom), 0) << points;
  }
}

TEST_P(Styles, StrandsStartOnTheScalpAndHaveEqualPiecesAndTheirLength) {
  const int strands = which_ == Which::bust ? 200 : 500;
  const Groom groom = grow_groom(head_, style_, {.strands = strands, .seed = 3});
  ASSERT_EQ(groom.strands.size(), static_cast<std::size_t>(strands));
  for (const Eigen::VectorXd& x : groom.strands) {
    ASSERT_EQ(x.size(), 3 * style_.points);
    EXPECT_NEAR(head_.surface_at(x.head<3>()).distance, 0, 1e-15);
    EXPECT_TRUE(head_.has_hair(x.head<3>()));
    EXPECT_TRUE(x.allFinite());
  }
  const GroomMeasures measures = measure_groom(groom);
  for (const Oddity& one : measures.odd) ADD_FAILURE() << one.count << " " << one.what;
  // Chords of curls, at least eight to a turn, are shorter than their arcs by up to (pi / 4)^2 / 24, 2.6 %.
  const double shortest = style_.length * (1 - style_.varies), longest = style_.length * (1 + style_.varies);
  EXPECT_GE(measures.length.min, 0.97 * shortest);
  // Tied hair also has its way to the tie: at most the half of the head's largest circle, and the layer of
  // hair.
  EXPECT_LE(measures.length.max, 1.01 * longest + (style_.tie ? 0.36 : 0));
  if (!style_.tie) {
    // Clumps have lengths of their own, spread evenly: three standard deviations of their mean.
    const double clumps = strands / style_.clump;
    EXPECT_NEAR(measures.length.mean, style_.length,
                3 * style_.varies / std::sqrt(3 * clumps) * style_.length);
  }
}

TEST_P(Styles, ASeedGivesTheSameAndAnotherOthers) {
  const GrowSettings settings{.strands = 100};
  const Groom groom = grow_groom(head_, style_, settings);
  EXPECT_EQ(grow_groom(head_, style_, settings).strands, groom.strands);
  EXPECT_NE(grow_groom(head_, style_, {.strands = 100, .seed = 2}).strands, groom.strands);
}

TEST_P(Styles, AHeadElsewhereHasTheSameHair) {
  if (which_ == Which::bust) GTEST_SKIP() << "a bust has its own place";
  const Vector3d there(1, -2, 3);
  const EllipsoidHead head({0.076, 0.096, 0.112}, there);
  const Groom here = grow_groom(head_, style_, {.strands = 50}),
              moved = grow_groom(head, style_, {.strands = 50});
  for (std::size_t i = 0; i < 50; ++i)
    // The rounding error is 4e-16, and some hundred steps may double it a few times.
    for (Eigen::Index k = 0; k < here.strands[i].size(); k += 3)
      ASSERT_NEAR((moved.strands[i].segment<3>(k) - there - here.strands[i].segment<3>(k)).norm(), 0, 1e-10);
}

double distance_from(const Line& line, const Vector3d& point) {
  double least = (line[0] - point).norm();
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vector3d piece = line[k] - line[k - 1];
    const double t = std::clamp((point - line[k - 1]).dot(piece) / piece.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (line[k - 1] + t * piece - point).norm());
  }
  return least;
}

TEST_P(Styles, TipsGatherAtTheirClumpsLine) {
  const LineSettings settings{0.001, 0.004};
  const std::vector<RootFrame> roots = scalp_roots(head_, which_ == Which::bust ? 120 : 300, 1);
  std::vector<Vector3d> places;
  for (const RootFrame& root : roots) places.push_back(root.position);
  const NearestPoints tree(places);
  std::vector<double> left, longer;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const RootFrame& other =
        roots[static_cast<std::size_t>(tree.nearest(places[i], static_cast<long>(i)).index)];
    const auto line = [&](const RootFrame& root, double length, double gathered, const Line* clump) {
      return middle_line(head_, style_, root,
                         {.length = length, .direction = root.axis, .gathered = gathered}, settings, clump);
    };
    const Line clump = line(roots[i], 0.3, 0, nullptr);
    const Line alone = line(other, 0.27, 0, &clump), drawn = line(other, 0.27, 0.8, &clump);
    const double loose = distance_from(clump, alone.back());
    if (loose > 0.002) left.push_back(distance_from(clump, drawn.back()) / loose);
    // Strands move across and not along: a gap of 2 cm makes 27 cm longer by 0.7 mm, less than a step.
    longer.push_back(std::abs(static_cast<double>(drawn.size()) - static_cast<double>(alone.size())));
  }
  // At nine tenths of the clump's length 0.972 of the 0.8 is done, and 0.22 of the gap remains; behind a tie
  // more remains, because much is done before hair falls.
  EXPECT_GT(left.size(), 20U);
  EXPECT_LE(spread_of(longer).median, 1);
  EXPECT_LT(spread_of(left).median, style_.tie ? 0.5 : 0.3);
}

INSTANTIATE_TEST_SUITE_P(All, Styles,
                         testing::Combine(testing::Values("long-smooth", "short-curly", "wavy", "ponytail"),
                                          testing::Values(Which::ellipsoid, Which::bust)),
                         [](const auto& style) {
                           std::string name = std::get<0>(style.param);
                           std::erase(name, '-');
                           return name + (std::get<1>(style.param) == Which::bust ? "OnABust" : "");
                         });

TEST(Grow, CurlsHaveTheCurvatureOfTheirHelix) {
  const HairStyle& style = *find_hair_style("short-curly");
  const Spread curvature =
      measure_groom(grow_groom(EllipsoidHead(), style, {.strands = 500, .points = 128})).curvature;
  const auto of_helix = [&](double radius) {
    const double c = style.pitch / (2 * M_PI);
    return radius / (radius * radius + c * c);
  };
  // Radii are 0.8 to 1.2 of the style's.
  EXPECT_GT(curvature.median, of_helix(1.2 * style.radius));
  EXPECT_LT(curvature.median, of_helix(0.8 * style.radius));
  // Smooth hair hangs straight, or follows the head, whose radii are at most 11.2 cm.
  EXPECT_LT(measure_groom(grow_groom(EllipsoidHead(), *find_hair_style("long-smooth"), {.strands = 500}))
                .curvature.median,
            1 / 0.112);
}

// Strands that grow nearer to the end of a style's hair lie below the others: far from their roots, they are
// nearer to the head by a part of the layer.
TEST(Grow, HairCoversTheHairBelowIt) {
  const Bust bust;
  const HairStyle& style = *find_hair_style("long-smooth");
  double above = 0, below = 0, highest = 0, lowest = 0;
  for (const Eigen::VectorXd& x : grow_groom(bust, style, {.strands = 2000}).strands)
    for (Eigen::Index k = 0; k < x.size(); k += 3) {
      const Vector3d point = x.segment<3>(k);
      if (std::abs(point.z()) > 0.01 || (point - x.head<3>()).norm() < 0.04) continue;
      const bool high = x[2] > 0.08;
      (high ? above : below) += 1;
      (high ? highest : lowest) += bust.surface_at(point).distance;
    }
  ASSERT_GT(std::min(above, below), 50);
  EXPECT_GT(highest / above - lowest / below, 0.1 * style.layer);
}

TEST(Grow, TiedHairPassesTheTie) {
  HairStyle style = *find_hair_style("ponytail");
  const EllipsoidHead head;
  const Vector3d at = head.surface_towards(style.tie->normalized());
  const Vector3d tie = at + 0.025 * head.surface_at(at).normal;
  for (const double length : {style.length, 0.01}) {
    style.length = length;
    const Groom groom = grow_groom(head, style, {.strands = 1000});
    // Short hair does not circle about its tie, either: half of the head's largest circle leads there.
    EXPECT_LT(measure_groom(groom).length.max, 1.1 * (1 + style.varies) * length + 0.36);
    long passing = 0;
    for (const Eigen::VectorXd& x : groom.strands) {
      double least = 1;
      for (Eigen::Index k = 0; k < x.size(); k += 3) least = std::min(least, (x.segment<3>(k) - tie).norm());
      // The sum of the tie's radius, two steps, and half of a piece of the strand.
      if (least < 0.011 + 0.008 + 0.006) ++passing;
    }
    EXPECT_GE(passing, 990);
  }
}

TEST(Grow, WhatCanNotGrowIsRefused) {
  const EllipsoidHead head;
  const HairStyle& curly = *find_hair_style("short-curly");
  const auto reason = [&](const GrowSettings& settings) -> std::string {
    return tests::refusal<std::invalid_argument>([&] { grow_groom(head, curly, settings); });
  };
  EXPECT_EQ(reason({.strands = 0}), "a groom of 0 strands; 1 or more are right");
  EXPECT_EQ(reason({.strands = 10, .points = 16}), "strands of 16 points; short-curly has " +
                                                       std::to_string(fewest_points(curly)) +
                                                       " at least, to follow its shape");
  EXPECT_EQ(reason({.strands = 1'000'000}),
            "1000000 strands of 64 points; a groom has at most 20000000 points in all");
  EXPECT_EQ(grow_groom(head, curly, {.strands = 1}).strands.size(), 1U);
  for (const HairStyle& style : hair_styles()) EXPECT_GE(style.points, fewest_points(style)) << style.name;
  EXPECT_EQ(find_hair_style("bob"), nullptr);
}

}  // namespace
}  // namespace hair
