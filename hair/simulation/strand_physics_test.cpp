// STAFF ONLY. Strands against closed forms; wavy and curly hair keeps its shape, and returns to it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

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

constexpr double kLength = 0.05;

hair::RestShape wave() {
  return hair::wavy_shape(12, kLength, 0.003, 0.02, {});
}

hair::RestShape curl() {
  return hair::curly_shape(12, kLength, 0.006, 0.015, {});
}

double farthest(const Eigen::VectorXd& difference) {
  double most = 0;
  for (Eigen::Index i = 0; i < difference.size(); i += 3)
    most = std::max(most, difference.segment<3>(i).norm());
  return most;
}

TEST(RestShapeMotion, WithoutGravityWavesAndCurlsStayPut) {
  for (Method method : kMethods)
    for (const hair::RestShape& shape : {wave(), curl()}) {
      const bool implicit = method == Method::implicit_euler || method == Method::predictor_corrector;
      Simulation simulation(alone(hair::start_at_rest({}, shape), method, implicit ? 1.0 / 240 : 1e-7));
      ASSERT_FALSE(simulation.advance(100)) << name_of(method);
      // Rounding of x changes lengths by 2^-53 x and causes forces of EA / l0 times that, 1e-12 N. An
      // explicit method moves a particle of 2.5e-8 kg by 1e-14 m within its 1e-5 s, an implicit one by as
      // much as bending yields.
      EXPECT_LE(farthest(simulation.state(0).x - shape.x), 1e-10 * kLength) << name_of(method);
    }
}

// Drag damps the swing: with 1e-3 N s/m^2 a hair of 1e-5 kg/m loses its velocity in 10 ms.
Description damped(const hair::RestShape& shape, Method method, double gravity) {
  Description description = alone(hair::start_at_rest({}, shape), method, 1.0 / 240);
  description.drag = 1e-3;
  description.gravity = gravity * kDown;
  return description;
}

TEST(RestShapeMotion, UnderGravityACurlSagsAndWithoutItComesBack) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector})
    for (const hair::RestShape& shape : {wave(), curl()}) {
      Simulation heavy(damped(shape, method, kG));
      ASSERT_FALSE(heavy.advance(240));
      const double sag = farthest(heavy.state(0).x - shape.x);
      EXPECT_GT(sag, 1e-3 * kLength) << name_of(method);

      Description again = damped(shape, method, 0);
      again.strands[0].state = heavy.state(0);
      Simulation weightless(std::move(again));
      ASSERT_FALSE(weightless.advance(480));
      EXPECT_LE(farthest(weightless.state(0).x - shape.x), 0.01 * sag) << name_of(method);
    }
}

}  // namespace
}  // namespace reference_tests
