// STAFF ONLY. Interpolation makes curls smaller, and extrapolation does not.
//
// A curl with the phase p is a helix of radius r about an axis; between guides with the weights w_k the
// helices add up to one of radius r |sum of w_k e^(i p_k)|. With random phases the mean of its square is r^2
// times the mean of the sum of w_k^2: a third in the middle of a triangle, a half on average over it.
#include <gtest/gtest.h>

#include "hair/dense/test_guides.h"

namespace reference_tests {
namespace {

using hair::Synthesis, hair::SynthesisMode;

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

}  // namespace
}  // namespace reference_tests
