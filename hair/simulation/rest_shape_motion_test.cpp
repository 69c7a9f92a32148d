// STAFF ONLY. Wavy and curly hair: it keeps its shape without forces, and returns to it.

#include <gtest/gtest.h>

#include <cmath>

#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

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
