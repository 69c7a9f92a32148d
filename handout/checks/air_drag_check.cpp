// The public checks of X1. Every failure prints the input, what was expected, what came, the error and its bound. The contract is in
// particles/air_drag.h.

#include "particles/air_drag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "check.h"
#include "derivative.h"

using namespace checks;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

const double kU = std::ldexp(1.0, -53);

VectorXd drag(double coefficient, const VectorXd& wind, const VectorXd& v) {
  VectorXd f = VectorXd::Zero(v.size());
  particles::add_air_drag(coefficient, wind, v, f);
  return f;
}

}  // namespace

TEST(AddAirDrag, OfOneParticleInAirAtRest) {
  // |v| = 3 m/s: 2 kg/m * 3 m/s * 3 m/s.
  expect_entries(drag(2, Vector3d::Zero(), Vector3d(1, -2, 2)), Vector3d(-6, 12, -12), 16 * kU * 18,
                 "the drag on a particle with v = (1, -2, 2) m/s in air at rest, c = 2 kg/m",
                 "16 u of c |v|^2: rounding");
}

TEST(AddAirDrag, DependsOnTheVelocityRelativeToTheAir) {
  expect_entries(drag(2, Vector3d(5, 1, 4), Vector3d(4, 3, 2)), Vector3d(6, -12, 12), 16 * kU * 18,
                 "the drag on a particle with v = (4, 3, 2) m/s in a wind of (5, 1, 4) m/s, c = 2 kg/m",
                 "16 u of c |w - v|^2: rounding");
  EXPECT_EQ(drag(2, Vector3d(5, 1, 4), Vector3d(5, 1, 4)), VectorXd::Zero(3))
      << "a particle that moves with the air";
}

TEST(AddAirDrag, OfEachParticleIsItsOwn) {
  for (int n : {0, 1, 2, 7}) {
    const VectorXd wind = 3 * scattered_vector(3 * n, 1), v = 4 * scattered_vector(3 * n, 2),
                   f = drag(0.5, wind, v);
    for (int i = 0; i < n; ++i) {
      const Vector3d u = wind.segment<3>(3 * i) - v.segment<3>(3 * i);
      expect_entries(f.segment<3>(3 * i), 0.5 * u.norm() * u, 16 * kU * 0.5 * 200,
                     "the drag on particle " + std::to_string(i) + " of " + std::to_string(n),
                     "16 u of c |w - v|^2: rounding");
    }
  }
}

TEST(AddAirDrag, IsAddedToWhatFHolds) {
  const VectorXd wind = scattered_vector(6, 3), v = scattered_vector(6, 4), before = scattered_vector(6, 5);
  VectorXd f = before;
  particles::add_air_drag(1, wind, v, f);
  expect_entries(f, before + drag(1, wind, v), 8 * kU * 13, "f, which held " + particles_in_words(before),
                 "8 u of the largest sum: rounding");
}

TEST(AddAirDrag, OfVeryFastParticlesIsANumber) {
  expect_entries(drag(1e-200, Vector3d::Zero(), Vector3d(0, 0, 1e140)), Vector3d(0, 0, -1e80), 16 * kU * 1e80,
                 "the drag at 1e140 m/s, c = 1e-200 kg/m", "16 u of c |v|^2: rounding");
}

int main(int argc, char** argv) {
  static const VectorXd still = VectorXd::Zero(3);
  static VectorXd out = still;
  return run(argc, argv,
             {{"add_air_drag", "AddAirDrag", [] { particles::add_air_drag(1, still, still, out); }}});
}
