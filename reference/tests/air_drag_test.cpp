// STAFF ONLY. What the drag of particles/air_drag.h does to a motion.
#include "particles/air_drag.h"

#include <gtest/gtest.h>

#include <cmath>

namespace reference_tests {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// In air at rest m v' = -c v^2, hence v(t) = v0 / (1 + c v0 t / m). Explicit Euler steps are off by h/2 max|v''| t = (c v0 / m)^2 v0 h t
// at most.
TEST(AirDrag, SlowsAParticleLikeOneOverTime) {
  const double c = 0.5, m = 2, v0 = 3, h = 1e-4;
  const int steps = 20000;
  VectorXd v(3);
  v << 0, v0, 0;
  for (int step = 0; step < steps; ++step) {
    VectorXd f = VectorXd::Zero(3);
    particles::add_air_drag(c, VectorXd::Zero(3), v, f);
    v += h / m * f;
  }
  const double t = h * steps, rate = c * v0 / m;
  EXPECT_NEAR(v[1], v0 / (1 + rate * t), rate * rate * v0 * h * t);
}

// Seen from a frame that moves with the wind, the air is at rest; turned by a rotation, the force turns, too.
TEST(AirDrag, IsTheSameInEveryFrame) {
  const Vector3d v(0.3, -2, 1.1), wind(4, 0.5, -0.7);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -2) / 3).toRotationMatrix();
  const auto drag = [](const Vector3d& air, const Vector3d& velocity) {
    VectorXd f = VectorXd::Zero(3);
    particles::add_air_drag(0.7, VectorXd(air), VectorXd(velocity), f);
    return Vector3d(f);
  };
  const double rounding = 32 * 0x1p-53 * 0.7 * (wind - v).squaredNorm();
  EXPECT_LE((drag(Vector3d::Zero(), v - wind) - drag(wind, v)).norm(), rounding);
  EXPECT_LE((drag(turn * wind, turn * v) - turn * drag(wind, v)).norm(), rounding);
}

}  // namespace
}  // namespace reference_tests
