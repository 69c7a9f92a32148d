#include "hair/strand/strand_spec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hair {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// The tangent's angle to the axis is the integral of the curvature. By Simpson's rule: its error falls with
// the fourth power of the step, and 4,000 of them in two waves leave less than 1e-9.
TEST(StrandSpec, AWavesCurvatureTurnsItsTangent) {
  const Wavy wave{0.004, 0.03};
  const double length = 0.06, k = kTurn / wave.wavelength;
  const int steps = 4000;
  const double ds = length / steps;
  double turned = 0;
  for (int i = 0; i < steps; ++i)
    turned += ds / 6 *
              (bend_at(wave, i * ds).curvature + 4 * bend_at(wave, (i + 0.5) * ds).curvature +
               bend_at(wave, (i + 1) * ds).curvature);
  const auto angle = [&](double t) { return std::atan(wave.amplitude * k * std::cos(k * t)); };
  EXPECT_NEAR(turned, angle(wave_axis(wave.amplitude, wave.wavelength, length)) - angle(0), 1e-9);
  EXPECT_EQ(bend_at(wave, 0.01).torsion, 0);
}

TEST(StrandSpec, AHelixHasItsCurvatureAndTorsionEverywhere) {
  const Curly curl{0.003, 0.01};
  const double c = curl.pitch / kTurn;
  for (const double s : {0.0, 0.02, 0.1}) {
    const Bend bend = bend_at(curl, s);
    // A turn is 2 pi sqrt(r^2 + c^2) long, and curvature^2 + torsion^2 = 1 / (r^2 + c^2).
    EXPECT_NEAR(std::hypot(bend.curvature, bend.torsion), 1 / std::hypot(curl.radius, c), 1e-9);
    EXPECT_NEAR(bend.torsion / bend.curvature, -c / curl.radius, 1e-12);
  }
}

TEST(StrandSpec, StraightHairDoesNotBend) {
  EXPECT_EQ(bend_at(Straight{}, 0.05).curvature, 0);
  EXPECT_EQ(bend_at(Straight{}, 0.05).torsion, 0);
}

TEST(StrandSpec, ItsShapeIsThatOfItsForm) {
  StrandSpec spec;
  spec.form = Curly{0.003, 0.01};
  spec.elements = 40;
  EXPECT_EQ(rest_shape(spec).x, curly_shape(40, spec.length, 0.003, 0.01, spec.root).x);
  spec.form = Wavy{0.002, 0.02};
  EXPECT_EQ(rest_shape(spec).x, wavy_shape(40, spec.length, 0.002, 0.02, spec.root).x);
}

}  // namespace
}  // namespace hair
