#include "hair/strand/make_strand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "hair/strand/rest_shape.h"
#include "hair/strand/strand_spec.h"
#include "solver/test_numbers.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

using reference_tests::kUnit;

// The message with which a call refuses its input; "" if it accepts it.
std::string refusal(const std::function<void()>& call) {
  return tests::refusal<std::invalid_argument>([&] { call(); });
}

TEST(MakeStrand, MassesAreHalfOfTheSegmentsBesideThem) {
  const Material hair;
  const Strand strand = uniform_strand(hair, 30, 0.3);
  const double segment = hair.line_density() * 0.3 / 30;
  ASSERT_EQ(strand.count(), 31);
  ASSERT_EQ(strand.segments(), 30);
  EXPECT_DOUBLE_EQ(strand.mass[0], segment / 2);
  EXPECT_DOUBLE_EQ(strand.mass[30], segment / 2);
  for (int i = 1; i < 30; ++i) EXPECT_DOUBLE_EQ(strand.mass[i], segment);
  // A sum of 31 terms is within 31 u of itself; each mass has 4 roundings.
  EXPECT_NEAR(strand.mass.sum(), hair.line_density() * 0.3, 40 * kUnit * strand.mass.sum());
}

TEST(MakeStrand, RefiningChangesNeitherMassNorLengthNorRigidity) {
  const Strand coarse = uniform_strand({}, 10, 0.3), fine = uniform_strand({}, 80, 0.3);
  EXPECT_NEAR(fine.mass.sum(), coarse.mass.sum(), 100 * kUnit * coarse.mass.sum());
  EXPECT_NEAR(fine.rest_length.sum(), 0.3, 100 * kUnit);
  EXPECT_EQ(fine.stretch_rigidity, coarse.stretch_rigidity);
  EXPECT_EQ(fine.bend_rigidity, coarse.bend_rigidity);
}

TEST(MakeStrand, HumanHairHasTheTextbooksRigidities) {
  const Strand strand = uniform_strand({}, 1, 0.1);
  EXPECT_NEAR(strand.stretch_rigidity, 3e9 * std::numbers::pi * 25e-10, 1e-12);     // E pi R^2
  EXPECT_NEAR(strand.bend_rigidity, 3e9 * std::numbers::pi * 6.25e-18 / 4, 1e-20);  // E pi R^4 / 4
}

TEST(MakeStrand, RestLengthsAreDistances) {
  Eigen::VectorXd x(9);
  x << 1, 2, 3, 1, 2, 5, 4, 6, 5;
  const Strand strand = strand_from_rest({}, x);
  EXPECT_DOUBLE_EQ(strand.rest_length[0], 2);
  EXPECT_DOUBLE_EQ(strand.rest_length[1], 5);
  EXPECT_DOUBLE_EQ(strand.mass[1] / strand.mass[0], 3.5);
  EXPECT_DOUBLE_EQ(strand.mass[2] / strand.mass[0], 2.5);
}

TEST(MakeStrand, ALoneParticleHasAMass) {
  const Strand strand = strand_from_rest({}, Eigen::VectorXd::Zero(3));
  EXPECT_EQ(strand.segments(), 0);
  EXPECT_GT(strand.mass[0], 0);
}

TEST(MakeStrand, BadInputIsNamedWithItsValueAndBound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([] { uniform_strand({}, 0, 1); }),
            "a strand's segments is 0; it must be finite and at least 1");
  EXPECT_EQ(refusal([] { uniform_strand({}, 3, -1); }), "a strand's length is -1; it must be finite and > 0");
  EXPECT_EQ(refusal([&] { uniform_strand({}, 3, nan); }),
            "a strand's length is nan; it must be finite and > 0");
  EXPECT_EQ(refusal([] { uniform_strand({.radius = 0}, 3, 1); }),
            "a material's radius is 0; it must be finite and > 0");
  EXPECT_EQ(refusal([] { uniform_strand({.density = -5}, 3, 1); }),
            "a material's density is -5; it must be finite and > 0");
  EXPECT_EQ(refusal([] { uniform_strand({.young_modulus = 0}, 3, 1); }),
            "Young's modulus is 0; it must be finite and > 0");
  EXPECT_NE(refusal([] { uniform_strand({.radius = 1e-200}, 3, 1); }), "");  // masses underflow
  EXPECT_EQ(refusal([] { strand_from_rest({}, Eigen::VectorXd()); }),
            "the numbers in a strand's positions is 0; it must be finite and at least 3");
  EXPECT_EQ(refusal([] { strand_from_rest({}, Eigen::VectorXd::Zero(4)); }),
            "the numbers in a strand's positions is 4; it must be a multiple of 3");
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, 0, 1);
  x.tail<3>() = x.segment<3>(3);
  EXPECT_EQ(refusal([&] { strand_from_rest({}, x); }),
            "the rest length of segment 1 is 0; it must be finite and > 0");
  x[4] = nan;
  EXPECT_EQ(refusal([&] { strand_from_rest({}, x); }), "a strand's position is nan; it must be finite");
}

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

constexpr double kPi = std::numbers::pi;

RootFrame tilted() {
  RootFrame frame;
  frame.position = Vector3d(0.1, -0.2, 1.5);
  frame.axis = Vector3d(2, -1, 2) / 3;
  frame.side = Vector3d(1, 2, 0).normalized();
  return frame;
}

Vector3d particle(const RestShape& shape, int i) {
  return shape.x.segment<3>(3 * i);
}

TEST(RestShape, AllBeginAtTheRootWithFramesOfLengthOne) {
  for (const RestShape& shape :
       {straight_shape(20, 0.2, tilted()), wavy_shape(40, 0.2, 0.005, 0.04, tilted()),
        curly_shape(40, 0.2, 0.01, 0.02, tilted())}) {
    EXPECT_LE((particle(shape, 0) - tilted().position).norm(), 1e-15);
    EXPECT_NEAR(shape.tangent.norm(), 1, 1e-15);
    EXPECT_NEAR(shape.normal.norm(), 1, 1e-15);
    EXPECT_NEAR(shape.normal.dot(shape.tangent), 0, 1e-15);
  }
}

TEST(RestShape, StraightGoesAlongTheAxis) {
  const RestShape shape = straight_shape(20, 0.2, tilted());
  for (int i = 0; i <= 20; ++i)
    EXPECT_LE((particle(shape, i) - tilted().position - 0.01 * i * tilted().axis).norm(), 1e-15);
}

// The arc length of the sine by Simpson's rule, from t on the axis to t'.
double sine_length(double amplitude, double wavelength, double from, double to) {
  const int n = 200;
  const double k = 2 * kPi / wavelength, h = (to - from) / n;
  double sum = 0;
  for (int j = 0; j <= n; ++j)
    sum += (j == 0 || j == n ? 1
            : j % 2 == 1     ? 4
                             : 2) *
           std::hypot(1, amplitude * k * std::cos(k * (from + h * j)));
  return sum * h / 3;
}

TEST(RestShape, WavyLiesOnTheSineAtEqualArcLengths) {
  for (const double amplitude : {0.0, 1e-4, 0.005, 0.04}) {
    const double wavelength = 0.04, length = 0.2;
    const int segments = 50;
    const RestShape shape = wavy_shape(segments, length, amplitude, wavelength, tilted());
    double last = 0;
    for (int i = 0; i <= segments; ++i) {
      const Vector3d local = particle(shape, i) - tilted().position;
      const double t = local.dot(tilted().axis);
      EXPECT_NEAR(local.dot(tilted().side), amplitude * std::sin(2 * kPi * t / wavelength), 1e-15);
      EXPECT_NEAR(local.dot(tilted().axis.cross(tilted().side)), 0, 1e-15);
      // Runge and Kutta's error is about (1/50)^4 / 120 of the integral.
      if (i > 0) {
        EXPECT_NEAR(sine_length(amplitude, wavelength, last, t), length / segments, 1e-8 * length / segments)
            << i;
      }
      last = t;
    }
  }
}

TEST(RestShape, CurlyHasTheHelixsRadiusPitchAndHandedness) {
  const double radius = 0.01, pitch = 0.02, length = 0.2;
  const int segments = 60;
  const RestShape shape = curly_shape(segments, length, radius, pitch, tilted());
  const Vector3d side = tilted().side, axis = tilted().axis, up = axis.cross(side);
  const double turn = std::hypot(2 * kPi * radius, pitch);  // m of hair
  for (int i = 0; i <= segments; ++i) {
    const Vector3d from_axis = particle(shape, i) - tilted().position + radius * side;
    const double angle = 2 * kPi * length * i / segments / turn;
    EXPECT_NEAR(from_axis.dot(axis), pitch * angle / (2 * kPi), 1e-14);
    EXPECT_NEAR(from_axis.dot(side), radius * std::cos(angle), 1e-14);
    EXPECT_NEAR(from_axis.dot(up), radius * std::sin(angle), 1e-14);
  }
  // The torsion's sign is that of (p' x p'') . p''': right-handed.
  const Vector3d a = particle(shape, 1) - particle(shape, 0), b = particle(shape, 2) - particle(shape, 1),
                 c = particle(shape, 3) - particle(shape, 2);
  EXPECT_GT(a.cross(b).dot(c), 0);
}

TEST(RestShape, TheTangentIsTheCurvesFirstDirection) {
  // A chord of length s deviates from a curve by at most the angle curvature * s / 2.
  const int segments = 100'000;
  const double length = 0.2;
  const RestShape curly = curly_shape(segments, length, 0.01, 0.02, tilted());
  const Vector3d first = (particle(curly, 1) - particle(curly, 0)).normalized();
  EXPECT_LE((first - curly.tangent).norm(), 0.5 * length / segments / 0.01);
  const RestShape wavy = wavy_shape(segments, length, 0.005, 0.04, tilted());
  const double curvature = 0.005 * std::pow(2 * kPi / 0.04, 2);
  EXPECT_LE(((particle(wavy, 1) - particle(wavy, 0)).normalized() - wavy.tangent).norm(),
            0.5 * curvature * length / segments);
}

TEST(RestShape, RefusesWhatSegmentsCantFollow) {
  const RootFrame frame;
  EXPECT_NO_THROW(wavy_shape(20, 0.2, 0.01, 0.04, frame));
  EXPECT_THROW(wavy_shape(19, 0.2, 0.01, 0.04, frame), std::invalid_argument);
  EXPECT_THROW(wavy_shape(20, 0.2, 0.05, 0.04, frame), std::invalid_argument);
  EXPECT_THROW(wavy_shape(20, 0.2, NAN, 0.04, frame), std::invalid_argument);
  EXPECT_THROW(wavy_shape(20, 0.2, 0.01, 0, frame), std::invalid_argument);
  EXPECT_THROW(curly_shape(10, 0.2, 0.01, 0.02, frame), std::invalid_argument);
  EXPECT_THROW(curly_shape(100, 0.2, -0.01, 0.02, frame), std::invalid_argument);
  EXPECT_THROW(curly_shape(100, 0.2, 0.01, 0, frame), std::invalid_argument);
  EXPECT_THROW(straight_shape(0, 0.2, frame), std::invalid_argument);
  EXPECT_THROW(straight_shape(10, INFINITY, frame), std::invalid_argument);
  RootFrame skew = frame;
  skew.side = Vector3d(1, 0, 1).normalized();
  EXPECT_THROW(straight_shape(10, 0.2, skew), std::invalid_argument);
}

}  // namespace
}  // namespace hair
