// STAFF ONLY. Strands against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

constexpr double kPi = std::numbers::pi;

hair::Measures measures(const Simulation& simulation) {
  return hair::measure(simulation.strand(0), simulation.particles(0), simulation.force(0),
                       simulation.state(0));
}

// A hair that hangs at rest: segment i carries the weight of the part below its middle.
StrandStart hanging_hair(int segments, double length, const hair::Material& material = {}) {
  StrandStart start = straight_hair(segments, length, kDown, material);
  const hair::Strand& strand = start.strand;
  double weight = kG * strand.mass.sum(), z = 0;
  for (int i = 0; i < segments; ++i) {
    weight -= kG * strand.mass[i];
    z -= strand.rest_length[i] * (1 + weight / strand.stretch_rigidity);
    start.state.x[3 * i + 5] = z;
  }
  return start;
}

// A hair that turns about its root as a whole: sum m r^2 w, at any position. A lever is accurate to 2^-51 m
// there, and again in the velocity.
TEST(StrandPhysics, AngularMomentumIsAboutTheRoot) {
  StrandStart start = straight_hair(10, 0.1);
  const Vector3d root(3, -2, 1), turn(0, 7, 0);
  double inertia = 0;
  for (int i = 0; i <= 10; ++i) {
    const Vector3d lever = start.state.x.segment<3>(3 * i);
    inertia += start.strand.mass[i] * lever.squaredNorm();
    start.state.v.segment<3>(3 * i) = turn.cross(lever);
    start.state.x.segment<3>(3 * i) += root;
  }
  const double bound = 2 * 0x1p-51 * start.strand.mass.sum() * 0.1 * turn.norm();
  const Simulation simulation(alone(std::move(start), Method::implicit_euler, 0.01));
  EXPECT_LE((measures(simulation).angular_momentum - inertia * turn).norm(), bound);
}

TEST(StrandPhysics, StretchUnderItsOwnWeightIsRhoGLSquaredOver2EForAnyNumberOfSegments) {
  const double length = 0.3;
  const hair::Material soft{.young_modulus = 3e5};
  const double expected = soft.density * kG * length * length / (2 * soft.young_modulus);
  for (int n : {1, 2, 3, 10, 57}) {
    const StrandStart start = hanging_hair(n, length, soft);
    EXPECT_NEAR(-start.state.x[3 * n + 2] - length, expected, 1e-13) << n;

    // It is at the balance: no particle has a force above the rounding of the root's, ρ g L A.
    Description description = alone(start, Method::implicit_euler, 0.01);
    description.gravity = kG * kDown;
    const Simulation simulation(std::move(description));
    Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * n + 3);
    simulation.force(0).add_force(start.state.x, start.state.v, f);
    const double weight = kG * start.strand.mass.sum();
    // A length is accurate to 2^-53 of x, and a spring's force to that times EA / l0.
    EXPECT_LE(f.tail(3 * n).cwiseAbs().maxCoeff(),
              8 * 0x1p-53 * (weight + start.strand.stretch_rigidity * length / (length / n)))
        << n;
  }
}

TEST(StrandPhysics, AHangingHairStaysAtRest) {
  for (Method method : kMethods) {
    const bool implicit = method == Method::implicit_euler || method == Method::predictor_corrector;
    // H6 has no stretch: the hair hangs straight down at its rest lengths.
    Description description =
        alone(method == Method::predictor_corrector ? straight_hair(10, 0.1) : hanging_hair(10, 0.1), method,
              implicit ? 1.0 / 240 : 1e-7);
    description.gravity = kG * kDown;
    const Eigen::VectorXd x = description.strands[0].state.x;
    Simulation simulation(std::move(description));
    ASSERT_FALSE(simulation.advance(100)) << name_of(method);
    const double fall = kG * simulation.time();
    // A solve to 1e-10 of a right-hand side of a (f + ...) leaves this part of gravity's effect in a step,
    // and rounding leaves 2^-53 EA / (m g) = 3e-7 of gravity.
    EXPECT_LE(simulation.state(0).v.cwiseAbs().maxCoeff(), 1e-4 * fall) << name_of(method);
    EXPECT_LE((simulation.state(0).x - x).cwiseAbs().maxCoeff(), 1e-6 * 0.1) << name_of(method);
  }
}

// Axial modes of n segments with half the mass at the tip: w_j = 2 sqrt(k/m) sin((2j - 1) pi / 4n), with
// shapes sin((2j - 1) pi i / 2n), at any stiffness: along a line springs are linear.
TEST(StrandPhysics, AxialModesSwingWithTheirFrequencies) {
  const int n = 8;
  for (const double stiffer : {1.0, 1e6}) {
    hair::Material material;
    material.young_modulus *= stiffer;
    for (int j = 1; j <= n; ++j) {
      StrandStart start = straight_hair(n, 0.08, kDown, material);
      const double k = material.stretch_rigidity() / 0.01, m = material.line_density() * 0.01;
      const double w = 2 * std::sqrt(k / m) * std::sin((2 * j - 1) * kPi / (4 * n));
      Eigen::VectorXd shape = Eigen::VectorXd::Zero(3 * n + 3);
      for (int i = 1; i <= n; ++i) shape[3 * i + 2] = 1e-4 * std::sin((2 * j - 1) * kPi * i / (2 * n));
      const Eigen::VectorXd rest = start.state.x;
      start.state.x += shape;

      const int steps = 1000;
      const double t = 2 * kPi / w * 1.3;  // cos(w t) and sin(w t) are both far from 0
      Simulation simulation(alone(std::move(start), Method::runge_kutta_4, t / steps));
      ASSERT_FALSE(simulation.advance(steps));
      // RK4: (w h)^4 / 120 of phase for each radian, with h a thousandth of 8.2 radians of this mode; other
      // modes, which rounding excites, are at most 2.8 sqrt(k/m) / w times as fast, for which h is small
      // enough, too.
      EXPECT_LE((simulation.state(0).x - rest - std::cos(w * t) * shape).cwiseAbs().maxCoeff(),
                1e-9 * 1e-4 + 1e-15)
          << "mode " << j << ", " << stiffer << " times as stiff";
    }
  }
}

// A root that is flung away at v strains the hair by v / c behind a front that moves at c = sqrt(E / rho):
// 6.6 % at 100 m/s. The root's displacement, v t, is the stretch of the part that the front has reached,
// which is c t long.
TEST(StrandPhysics, AFlungRootStrainsByItsSpeedOverTheSpeedOfSound) {
  const int n = 400;
  const hair::Material material;
  const double v = 100, c = std::sqrt(material.young_modulus / material.density);
  EXPECT_NEAR(v / c, 0.066, 0.0005);
  StrandStart start = straight_hair(n, 0.4, kDown, material);
  start.state.v[2] = v;
  const double h = 0.2 * 0.001 / c;
  Simulation simulation(alone(std::move(start), Method::runge_kutta_4, h));
  ASSERT_FALSE(simulation.advance(static_cast<long>(0.2 / c / h)));  // the front is in the middle
  // Behind the front strain rings around v / c; over many segments it averages out: within 2 %, ten times
  // less than the ringing.
  const double length = particle(simulation, 20)[2] - particle(simulation, 120)[2];
  EXPECT_NEAR(length / 0.1 - 1, v / c, 0.02 * v / c);
  // The part ahead of the front has not moved.
  EXPECT_LE(std::abs(particle(simulation, 260)[2] + 0.26), 1e-6);
}

}  // namespace
}  // namespace reference_tests
