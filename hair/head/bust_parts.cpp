#include "hair/head/bust_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hair {

namespace {

// This near to the surface, every part with an effect is included.
constexpr double kNearBust = 0.02;               // m
constexpr double kBottom = -0.35, kEdge = 0.03;  // m: the end of the chest, and the radius of its edge
// The two sides of a paired part meet in the middle without an edge: sqrt(x^2 + kMeeting^2) replaces |x|.
constexpr double kMeeting = 0.004;  // m

Bust::Value of_ellipsoid(const Vector3d& p, const Vector3d& radii) {
  const Vector3d inverse = radii.cwiseInverse(), q = p.cwiseProduct(inverse), u = q.cwiseProduct(inverse);
  const double k = q.norm(), g = u.norm();
  if (!(g > 0)) return {-radii.minCoeff(), Vector3d::UnitZ()};
  // The value is k (k - 1) / g, where u is half of the gradient of k^2, and g = |u|.
  const Vector3d slope_of_g = u.cwiseProduct(inverse).cwiseProduct(inverse) / g;
  return {k * (k - 1) / g, (2 - 1 / k) / g * u - k * (k - 1) / (g * g) * slope_of_g};
}

Bust::Value of_capsule(const Vector3d& p, const Vector3d& axis, double radius) {
  const double along = std::clamp(axis.dot(p) / axis.squaredNorm(), 0.0, 1.0);
  const Vector3d out = p - along * axis;
  const double distance = out.norm();
  return {distance - radius, distance > 0 ? Vector3d(out / distance) : axis.unitOrthogonal()};
}

Bust::Value smooth_minimum(const Bust::Value& a, const Bust::Value& b, double k) {
  const double h = std::max(k - std::abs(a.value - b.value), 0.0) / k;
  const Bust::Value &less = a.value < b.value ? a : b, &more = a.value < b.value ? b : a;
  return {less.value - 0.25 * k * h * h, (1 - 0.5 * h) * less.gradient + 0.5 * h * more.gradient};
}

Bust::Value negative(const Bust::Value& a) {
  return {-a.value, -a.gradient};
}

class BustParts {
 public:
  void ellipsoid(const Vector3d& centre, const Vector3d& radii, double blend) {
    all.push_back({PartShape::ellipsoid, centre.x() > 0, false, blend, centre, radii, 0, centre});
  }
  void hollow(const Vector3d& centre, const Vector3d& radii, double blend) {
    ellipsoid(centre, radii, blend);
    all.back().carved = true;
  }
  void capsule(const Vector3d& from, const Vector3d& to, double radius, double blend) {
    const bool paired = from.x() > 0 || to.x() > 0;
    all.push_back({PartShape::capsule, paired, false, blend, from, to, radius, 0.5 * (from + to)});
  }

  // A part may be left out if its value is above the others' by its blend. The parts joined before a joint
  // have an effect only if they are above its result by less than its blend; carving makes nothing lower.
  void set_reaches() {
    double later = 0;
    for (auto part = all.rbegin(); part != all.rend(); ++part) {
      const double above = kNearBust + part->blend + later;
      if (!part->carved) later += part->blend;
      double reach = 0.5 * (part->b - part->a).norm() + part->radius + above;
      if (part->shape == PartShape::ellipsoid) {
        // Its value is at least (its least radius / its largest) times the distance from its largest sphere.
        const double largest = part->b.maxCoeff();
        reach = largest + largest / part->b.minCoeff() * above;
      }
      part->reach_squared = reach * reach;
    }
  }

  std::vector<BustPart> all;
};

std::vector<BustPart> made_parts() {
  BustParts parts;
  // Skull, and the egg of the face.
  parts.ellipsoid({0, 0.012, 0.022}, {0.075, 0.086, 0.086}, 0.03);
  parts.ellipsoid({0, -0.028, 0.02}, {0.060, 0.064, 0.066}, 0.03);
  parts.ellipsoid({0, -0.023, -0.026}, {0.058, 0.058, 0.062}, 0.04);
  parts.ellipsoid({0, -0.031, -0.066}, {0.044, 0.047, 0.052}, 0.04);
  // Jaw and chin.
  parts.capsule({0.042, 0.006, -0.054}, {0.010, -0.058, -0.103}, 0.009, 0.035);
  parts.ellipsoid({0, -0.071, -0.105}, {0.018, 0.017, 0.014}, 0.03);
  // Neck, shoulders and chest.
  parts.capsule({0, 0.018, -0.066}, {0, 0.046, -0.24}, 0.046, 0.040);
  parts.ellipsoid({0, 0.026, -0.33}, {0.165, 0.096, 0.130}, 0.07);
  parts.capsule({0.02, 0.044, -0.226}, {0.160, 0.034, -0.284}, 0.040, 0.06);
  // The hollows of the eyes leave a brow, and the ridge of the nose.
  parts.hollow({0.038, -0.112, -0.007}, {0.027, 0.027, 0.014}, 0.025);
  parts.capsule({0, -0.085, 0.012}, {0, -0.1070, -0.039}, 0.0068, 0.020);
  parts.capsule({0.002, -0.100, -0.0450}, {0.011, -0.089, -0.0450}, 0.0046, 0.012);
  // Closed lips.
  parts.ellipsoid({0, -0.068, -0.076}, {0.031, 0.018, 0.019}, 0.028);
  parts.capsule({0, -0.0935, -0.0700}, {0.021, -0.0840, -0.0722}, 0.0035, 0.006);
  parts.capsule({0, -0.0920, -0.0790}, {0.014, -0.0868, -0.0762}, 0.0044, 0.005);
  // Ears.
  parts.ellipsoid({0.070, 0.016, -0.014}, {0.010, 0.014, 0.026}, 0.014);
  parts.set_reaches();
  return parts.all;
}

}  // namespace

std::span<const BustPart> bust_parts() {
  static const std::vector<BustPart> parts = made_parts();
  return parts;
}

Bust::Value value_of_parts(const Vector3d& point, LeaveOut leave_out) {
  const double side = std::hypot(point.x(), kMeeting);
  const Vector3d folded(side, point.y(), point.z());
  const std::span<const BustPart> parts = bust_parts();
  Bust::Value all = of_ellipsoid(point - parts.front().a, parts.front().b);
  for (const BustPart& part : parts.subspan(1)) {
    const Vector3d& at = part.paired ? folded : point;
    if (leave_out == LeaveOut::what_is_far && (at - part.middle).squaredNorm() > part.reach_squared) continue;
    Bust::Value own = part.shape == PartShape::ellipsoid
                          ? of_ellipsoid(at - part.a, part.b)
                          : of_capsule(at - part.a, part.b - part.a, part.radius);
    if (part.paired) own.gradient.x() *= point.x() / side;
    all = part.carved ? negative(smooth_minimum(negative(all), own, part.blend))
                      : smooth_minimum(all, own, part.blend);
  }
  const Bust::Value above_cut = {point.z() - kBottom, Vector3d::UnitZ()};
  return negative(smooth_minimum(negative(all), above_cut, kEdge));
}

}  // namespace hair
