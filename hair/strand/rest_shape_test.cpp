#include "hair/strand/rest_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hair {
namespace {

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
