// STAFF ONLY. Compares H10's frames with the area that directions go around. Motions of the whole head,
// threads and allocations are in hair/dense/synthesis_test.cpp.
#include "hair/strand_synthesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/H7/link_trees_for_tests.h"

namespace reference_tests {
namespace {

// Gauss and Bonnet: directions that go around an area of the unit sphere turn a frame by that area about
// themselves. The segments of a helix with N to a turn point to the corners of a regular polygon, at the
// angle a from the helix's axis, whose area is N times the excess e of a triangle at the pole: tan(e/2) = t^2
// sin c / (1 + t^2 cos c), t = tan(a/2), c = 2 pi / N.
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

}  // namespace
}  // namespace reference_tests
