// STAFF ONLY. H10 beside what defines it: nearest points by their inequality, frames by the area that directions go
// around. Motions of the whole head, threads and allocations: hair/head/synthesis_test.cpp.
#include "hair/strand_synthesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/tests/link_trees.h"

namespace reference_tests {
namespace {

// q of a convex set is the point nearest to p if and only if (p - q).(c - q) <= 0 for all c of the set; of a triangle, for
// its corners.
TEST(StrandSynthesis, WeightsAreThoseOfTheNearestPoint) {
  RandomNumbers numbers(1);
  for (int repeat = 0; repeat < 5000; ++repeat) {
    std::array<Vector3d, 3> corners = {numbers.vector(1), numbers.vector(1), numbers.vector(1)};
    if (repeat % 5 == 1) corners[2] = corners[0] + numbers.between(-1, 2) * (corners[1] - corners[0]);
    if (repeat % 5 == 2) corners[2] = corners[0];
    if (repeat % 5 == 3)
      corners[2] = corners[0] + numbers.between(-1, 2) * (corners[1] - corners[0]) + numbers.vector(1e-5);
    const Vector3d root = numbers.vector(2);
    const std::array<double, 3> weights = hair::root_weights(corners, root);
    const Vector3d nearest = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    // Thin triangles lose digits in proportion to their edges over their heights.
    const double bound = repeat % 5 == 3 ? 1e-9 : 1e-12;
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, bound);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(weights[k], 0);
      EXPECT_LE((root - nearest).dot(corners[k] - nearest), 10 * bound)
          << "corner " << k << ", case " << repeat;
    }
  }
}

// Gauss and Bonnet: directions that go around an area of the unit sphere turn a frame by that area about themselves. The
// segments of a helix with N to a turn point to the corners of a regular polygon, at the angle a from the helix's axis, whose
// area is N times the excess e of a triangle at the pole: tan(e/2) = t^2 sin c / (1 + t^2 cos c), t = tan(a/2), c = 2 pi / N.
TEST(StrandSynthesis, AFullTurnOfACurlTurnsFramesByTheAreaOfItsDirections) {
  for (const int N : {3, 5, 8, 40})
    for (const double angle : {0.1, 0.7, 1.2, 1.5}) {
      VectorXd points = VectorXd::Zero(3 * (N + 2));
      const double c = 2 * std::numbers::pi / N;
      for (int i = 0; i <= N; ++i)
        points.segment<3>(3 * i + 3) =
            points.segment<3>(3 * i) + 0.01 * Vector3d(std::sin(angle) * std::cos(c * i),
                                                       std::sin(angle) * std::sin(c * i), std::cos(angle));
      hair::GuideFrames frames{VectorXd(N + 2), std::vector<hair::Matrix3d>(static_cast<std::size_t>(N + 2))};
      hair::carry_along(points, frames);
      const double t = std::tan(angle / 2);
      const double area = 2 * N * std::atan2(t * t * std::sin(c), 1 + t * t * std::cos(c));
      const Vector3d direction = points.segment<3>(3).normalized();
      const hair::Matrix3d expected = Eigen::AngleAxisd(area, direction).toRotationMatrix();
      EXPECT_LE((frames.turns.back() - expected).norm(), 1e-13 * N) << N << " segments at " << angle;
    }
}

// Nearer to a fold than anything that a hair does, and at it.
TEST(StrandSynthesis, FramesStayRotationsAtFolds) {
  RandomNumbers numbers(2);
  for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 1e-16, 0.0})
    for (int repeat = 0; repeat < 50; ++repeat) {
      const Vector3d along = numbers.direction(), aside = along.cross(numbers.direction()).normalized();
      VectorXd points = VectorXd::Zero(9);
      points.segment<3>(3) = along;
      points.segment<3>(6) = off * aside;
      hair::GuideFrames frames{VectorXd(3), std::vector<hair::Matrix3d>(3)};
      hair::carry_along(points, frames);
      const hair::Matrix3d& turn = frames.turns[2];
      EXPECT_LE((turn.transpose() * turn - hair::Matrix3d::Identity()).norm(), 1e-14) << off;
      EXPECT_GT(turn.determinant(), 0) << off;
      // a + b rounds by 1e-16; the reference takes what is shorter than 1e-8 for a fold.
      EXPECT_LE((turn * along - (off * aside - along).normalized()).norm(), 4e-8) << off;
    }
}

}  // namespace
}  // namespace reference_tests
