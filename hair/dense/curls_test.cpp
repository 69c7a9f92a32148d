// STAFF ONLY. Interpolation makes curls smaller, and extrapolation does not.
//
// A curl with the phase p is a helix of radius r about an axis; between guides with the weights w_k the
// helices add up to one of radius r |sum of w_k e^(i p_k)|. With random phases the mean of its square is r^2
// times the mean of the sum of w_k^2: a third in the middle of a triangle, a half on average over it.

#include <gtest/gtest.h>

#include "hair/dense/synthesis.h"
#include "hair/dense/test_guides.h"

namespace reference_tests {
namespace {

using hair::Parents, hair::Synthesis, hair::SynthesisDescription, hair::SynthesisMode;

constexpr int kCurlPoints = 25, kChildren = 4000;
constexpr double kCurl = 0.005;

// The root of the mean square distance of a strand's points from the straight line through their mean along
// z.
double radius_of(const double* strand) {
  double sum = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (int i = 0; i < 24; ++i) middle += Eigen::Vector2d(strand[3 * i], strand[3 * i + 1]) / 24;
  for (int i = 0; i < 24; ++i)
    sum += (Eigen::Vector2d(strand[3 * i], strand[3 * i + 1]) - middle).squaredNorm() / 24;
  return std::sqrt(sum);
}

struct Curls {
  explicit Curls(SynthesisMode mode, double spread = 1)
      : roots(roots_on_disc(100, 0.05)),
        synthesis({.guides = roots,
                   .children = roots_on_disc(kChildren, 0.042),
                   .points = kCurlPoints,
                   .mode = mode,
                   .spread = spread}),
        strands(make_all(synthesis, curls(roots, kCurlPoints, kCurl, 0.01))) {}

  double radius(int child) const { return radius_of(strands.data() + 3 * kCurlPoints * child); }

  std::vector<hair::RootFrame> roots;
  Synthesis synthesis;
  std::vector<double> strands;
};

TEST(Curls, InterpolatedHaveTheRadiusOfTheMeanOfTheirPhases) {
  const Curls hair(SynthesisMode::interpolate);
  double squares = 0, weights = 0;
  for (int child = 0; child < kChildren; ++child) {
    const hair::Parents& parents = hair.synthesis.parents(child);
    std::complex<double> mean = 0;
    for (int k = 0; k < 3; ++k) {
      mean += parents.weights[k] * std::polar(1.0, some_phase(parents.guides[k]));
      weights += parents.weights[k] * parents.weights[k] / kChildren;
    }
    EXPECT_NEAR(hair.radius(child), kCurl * std::abs(mean), 1e-15) << "child " << child;
    squares += hair.radius(child) * hair.radius(child) / kChildren;
  }
  const double left = std::sqrt(squares) / kCurl;
  RecordProperty("radius", std::to_string(left));
  // 100 guides do not have the mean of all phases: 180 triangles, each of which differs by about a third.
  EXPECT_NEAR(left, std::sqrt(0.5), 0.1) << "the radius that is left of the guides'";
  EXPECT_NEAR(weights, 0.5, 0.02) << "the mean of the sum of the squares of weights";
}

TEST(Curls, OppositePhasesLeaveNone) {
  std::vector<RootFrame> roots(2);
  roots[0] = {Vector3d(-0.01, 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)};
  roots[1] = {Vector3d(0.01, 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)};
  const std::vector<RootFrame> children = {{Vector3d(0, 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)}};
  Synthesis synthesis(
      {.guides = roots, .children = children, .points = kCurlPoints, .mode = SynthesisMode::interpolate});
  VectorXd guides = curls(roots, kCurlPoints, kCurl, 0.01);
  // The second guide is the first one, turned by half a turn about its root.
  for (int i = 0; i < kCurlPoints; ++i) {
    const Vector3d from = guides.segment<3>(3 * i) - roots[0].position;
    guides.segment<3>(3 * (kCurlPoints + i)) = roots[1].position + Vector3d(-from.x(), -from.y(), from.z());
  }
  EXPECT_NEAR(radius_of(make_all(synthesis, guides).data()), 0, 1e-16);
}

// The distance of its points from the guide's is that of the roots, and so the circle keeps its radius.
TEST(Curls, ExtrapolatedKeepTheirRadius) {
  const Curls hair(SynthesisMode::extrapolate);
  double squares = 0;
  for (int child = 0; child < kChildren; ++child) {
    const double beside = (Eigen::Map<const Vector3d>(hair.strands.data() + 3 * kCurlPoints * child) -
                           hair.roots[hair.synthesis.parents(child).guides[0]].position)
                              .norm();
    EXPECT_NEAR(hair.radius(child), kCurl, beside + 1e-15) << "child " << child;
    squares += hair.radius(child) * hair.radius(child) / kChildren;
  }
  const double left = std::sqrt(squares) / kCurl;
  RecordProperty("radius", std::to_string(left));
  EXPECT_GE(left, 0.9) << "the radius that is left of the guides'";
}

constexpr int kPointsOfParted = 6;

// On a disc, hair left of the line x = 0 is combed to the left, and the other to the right.
std::vector<RootFrame> parted(std::vector<RootFrame> roots) {
  for (RootFrame& root : roots) root.side = Vector3d(root.position.x() < 0 ? -1 : 1, 0, 0);
  return roots;
}

SynthesisDescription parted_disc(SynthesisMode mode) {
  return {.guides = parted(roots_on_disc(60, 0.1)),
          .children = parted(roots_on_disc(1500, 0.095)),
          .points = kPointsOfParted,
          .mode = mode,
          .combed = true};
}

// Each guide goes 3 cm up and 10 cm to its side.
VectorXd combed_guides(const std::vector<RootFrame>& roots) {
  VectorXd x(static_cast<Eigen::Index>(3 * kPointsOfParted * roots.size()));
  Eigen::Index at = 0;
  for (const RootFrame& root : roots)
    for (int i = 0; i < kPointsOfParted; ++i, at += 3)
      x.segment<3>(at) = root.position + static_cast<double>(i) / (kPointsOfParted - 1) *
                                             (0.03 * root.axis + 0.1 * root.side);
  return x;
}

TEST(Parting, NoStrandGrowsBetweenItsTwoSides) {
  for (const SynthesisMode mode :
       {SynthesisMode::interpolate, SynthesisMode::extrapolate, SynthesisMode::blend}) {
    const SynthesisDescription description = parted_disc(mode);
    Synthesis synthesis(description);
    const VectorXd guides = combed_guides(description.guides);
    const std::vector<double> made = make_all(synthesis, guides);
    for (std::size_t child = 0; child < description.children.size(); ++child) {
      const RootFrame& root = description.children[child];
      const double tip = made[3 * (kPointsOfParted * (child + 1) - 1)];
      ASSERT_NEAR(tip, root.position.x() + 0.1 * root.side.x(), 1e-12)
          << "a strand between guides that all go to its side goes there, too; child " << child;
    }
  }
}

TEST(Parting, WeightsAreOfItsOwnSideAndTheirSumIs1) {
  const SynthesisDescription description = parted_disc(SynthesisMode::blend);
  Synthesis synthesis(description);
  int alone = 0;
  for (int child = 0; child < synthesis.children(); ++child) {
    const Parents& parents = synthesis.parents(child);
    const Vector3d& side = description.children[static_cast<std::size_t>(child)].side;
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(parents.weights[k], 0);
      EXPECT_GT(description.guides[static_cast<std::size_t>(parents.guides[k])].side.dot(side), 0);
      sum += parents.weights[k];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    alone += parents.guides[1] == parents.guides[0] ? 1 : 0;
  }
  EXPECT_GT(alone, 0) << "some triangles have one corner on a strand's side";
}

// A strand whose whole triangle is on the other side takes the nearest guide of its own side.
TEST(Parting, AStrandThatIsAloneTakesTheNearestGuideOfItsSide) {
  SynthesisDescription description = parted_disc(SynthesisMode::interpolate);
  description.children = {{Vector3d(0.05, 0, 0), description.children.front().axis, Vector3d(-1, 0, 0)}};
  const int guide = Synthesis(description).parents(0).guides[0];
  for (const RootFrame& other : description.guides)
    if (other.side.x() < 0) {
      EXPECT_LE(
          (description.guides[static_cast<std::size_t>(guide)].position - description.children[0].position)
              .norm(),
          (other.position - description.children[0].position).norm());
    }
  EXPECT_LT(description.guides[static_cast<std::size_t>(guide)].side.x(), 0);
}

}  // namespace
}  // namespace reference_tests
