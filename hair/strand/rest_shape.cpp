#include "hair/strand/rest_shape.h"

#include <cmath>
#include <numbers>

#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_finite, particles::require_positive;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

void check(int segments, double length, const RootFrame& frame) {
  require_at_least("a strand's segments", segments, 1);
  require_positive("a strand's length", length);
  for (double value : frame.position) require_finite("the root's position", value);
  const double tolerance = 1e-9;
  auto near = [&](double value, double wanted) { return std::abs(value - wanted) <= tolerance; };
  require(near(frame.axis.norm(), 1), "the length of the root's axis", frame.axis.norm(), "1");
  require(near(frame.side.norm(), 1), "the length of the root's side", frame.side.norm(), "1");
  require(near(frame.axis.dot(frame.side), 0), "axis . side", frame.axis.dot(frame.side), "0");
}

void check_resolved(double segment, double wave) {
  require(segment <= wave / 4, "the length of a segment over that of a wave or turn", segment / wave,
          "at most 1/4");
}

// From t on the axis to the place where the wave is longer by `length`: dt/ds = 1 / sqrt(1 + (A k
// cos(kt))^2), by Runge and Kutta's method. A wave turns over a length of at least 1 / (k (1 + A k)), which
// 50 steps follow to rounding.
double further_along(double amplitude, double wavelength, double t, double length) {
  const double k = kTurn / wavelength, steepness = amplitude * k;
  const int steps = static_cast<int>(std::ceil(50 * length * k * (1 + steepness)));
  const double h = length / steps;
  auto rate = [&](double at) { return 1 / std::hypot(1, steepness * std::cos(k * at)); };
  for (int j = 0; j < steps; ++j) {
    const double a = rate(t), b = rate(t + h / 2 * a), c = rate(t + h / 2 * b), d = rate(t + h * c);
    t += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return t;
}

// The first tangent, and the part of `side` that is perpendicular to it.
RestShape begin(int segments, const RootFrame& frame, const Vector3d& tangent) {
  RestShape shape{Eigen::VectorXd(3 * (segments + 1)), tangent.normalized(), {}};
  shape.normal = (frame.side - frame.side.dot(shape.tangent) * shape.tangent).normalized();
  return shape;
}

}  // namespace

Vector3d side_of(const Vector3d& axis) {
  const Vector3d start = std::abs(axis.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  return (start - axis.dot(start) * axis).normalized();
}

RestShape straight_shape(int segments, double length, const RootFrame& frame) {
  check(segments, length, frame);
  RestShape shape = begin(segments, frame, frame.axis);
  for (int i = 0; i <= segments; ++i)
    shape.x.segment<3>(3 * i) = frame.position + length * i / segments * frame.axis;
  return shape;
}

RestShape wavy_shape(int segments, double length, double amplitude, double wavelength,
                     const RootFrame& frame) {
  check(segments, length, frame);
  require_positive("a wavelength", wavelength);
  require(amplitude >= 0 && amplitude <= wavelength, "a wave's amplitude over its length",
          amplitude / wavelength, "from 0 to 1");
  const double segment = length / segments;
  check_resolved(segment, wavelength);

  const double k = kTurn / wavelength, steepness = amplitude * k;
  RestShape shape = begin(segments, frame, frame.axis + steepness * frame.side);
  double t = 0;
  for (int i = 0; i <= segments; ++i) {
    shape.x.segment<3>(3 * i) = frame.position + t * frame.axis + amplitude * std::sin(k * t) * frame.side;
    t = further_along(amplitude, wavelength, t, segment);
  }
  return shape;
}

double wave_axis(double amplitude, double wavelength, double s) {
  return further_along(amplitude, wavelength, 0, s);
}

RestShape curly_shape(int segments, double length, double radius, double pitch, const RootFrame& frame) {
  check(segments, length, frame);
  require_at_least("a curl's radius", radius, 0);
  require_positive("a curl's pitch", pitch);
  const double c = pitch / kTurn, per_radian = std::hypot(radius, c), segment = length / segments;
  check_resolved(segment, kTurn * per_radian);

  const Vector3d up = frame.axis.cross(frame.side);
  RestShape shape = begin(segments, frame, radius * up + c * frame.axis);
  for (int i = 0; i <= segments; ++i) {
    const double angle = i * segment / per_radian;
    shape.x.segment<3>(3 * i) = frame.position + radius * (std::cos(angle) - 1) * frame.side +
                                radius * std::sin(angle) * up + c * angle * frame.axis;
  }
  return shape;
}

}  // namespace hair
