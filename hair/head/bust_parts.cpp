#include "hair/head/bust_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hair {

namespace {

// This near to the surface, every part with an effect is included.
constexpr double kNearBust = 0.02;               // m
constexpr double kBottom = -0.35, kEdge = 0.03;  // m: the end of the chest, and the radius of its edge

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
  void ellipsoid(const Vector3d& centre, const Vector3d& radii, double blend, bool carved = false) {
    all.push_back({PartShape::ellipsoid, carved, blend, centre, radii, 0, centre});
  }
  void capsule(const Vector3d& from, const Vector3d& to, double radius, double blend) {
    all.push_back({PartShape::capsule, false, blend, from, to, radius, 0.5 * (from + to)});
  }
  // Left and right.
  void ellipsoids(const Vector3d& centre, const Vector3d& radii, double blend, bool carved = false) {
    for (const Vector3d& at : {centre, mirrored(centre)}) ellipsoid(at, radii, blend, carved);
  }
  void capsules(const Vector3d& from, const Vector3d& to, double radius, double blend) {
    capsule(from, to, radius, blend);
    capsule(mirrored(from), mirrored(to), radius, blend);
  }

  // A part may be left out if its value is above the others' by its blend. The parts joined before it may
  // still be above the surface, by as much as the later joints are wide; a joint lowers the value by a
  // quarter of its width.
  void set_reaches() {
    double later = 0;
    for (auto part = all.rbegin(); part != all.rend(); ++part) {
      const double above = kNearBust + part->blend + 1.25 * later;
      later = std::max(later, part->blend);
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

 private:
  static Vector3d mirrored(const Vector3d& x) { return {-x.x(), x.y(), x.z()}; }
};

std::vector<BustPart> made_parts() {
  BustParts parts;
  // Skull.
  parts.ellipsoid({0, 0.012, 0.022}, {0.075, 0.086, 0.086}, 0.03);
  // Neck and its muscles, shoulders and chest.
  parts.capsule({0, 0.026, -0.07}, {0, 0.034, -0.23}, 0.047, 0.032);
  parts.capsules({0.050, 0.022, -0.062}, {0.013, -0.014, -0.21}, 0.008, 0.025);
  parts.capsules({0.018, 0.050, -0.15}, {0.115, 0.038, -0.232}, 0.022, 0.05);
  parts.ellipsoid({0, 0.030, -0.33}, {0.185, 0.108, 0.145}, 0.05);
  parts.capsules({0.100, 0.030, -0.248}, {0.168, 0.030, -0.265}, 0.046, 0.05);
  parts.capsules({0.012, -0.036, -0.222}, {0.130, 0.000, -0.216}, 0.008, 0.03);
  // Forehead, face, cheekbones, jaw and chin.
  parts.ellipsoid({0, -0.028, 0.02}, {0.060, 0.064, 0.066}, 0.03);
  parts.ellipsoid({0, -0.040, -0.040}, {0.054, 0.049, 0.066}, 0.03);
  parts.ellipsoids({0.043, -0.060, -0.028}, {0.022, 0.020, 0.016}, 0.025);
  parts.ellipsoid({0, -0.046, -0.085}, {0.042, 0.042, 0.032}, 0.03);
  parts.capsules({0.042, -0.004, -0.064}, {0.018, -0.070, -0.100}, 0.009, 0.03);
  parts.ellipsoid({0, -0.080, -0.106}, {0.017, 0.014, 0.014}, 0.02);
  // Brows, sockets, and eyes with closed lids.
  parts.capsules({0.012, -0.084, 0.013}, {0.038, -0.075, 0.016}, 0.008, 0.018);
  parts.ellipsoids({0.032, -0.100, -0.004}, {0.019, 0.019, 0.012}, 0.014, true);
  parts.ellipsoids({0.031, -0.0745, -0.005}, {0.0150, 0.0120, 0.0110}, 0.006);
  // Nose and mouth.
  parts.capsule({0, -0.089, 0.004}, {0, -0.106, -0.034}, 0.0065, 0.016);
  parts.ellipsoid({0, -0.087, -0.030}, {0.011, 0.015, 0.020}, 0.015);
  parts.ellipsoid({0, -0.107, -0.039}, {0.0085, 0.0090, 0.0080}, 0.010);
  parts.ellipsoids({0.0105, -0.096, -0.0425}, {0.0060, 0.0095, 0.0060}, 0.014);
  parts.capsule({0, -0.086, -0.048}, {0, -0.101, -0.044}, 0.005, 0.014);
  parts.ellipsoid({0, -0.080, -0.073}, {0.026, 0.011, 0.017}, 0.012);
  parts.capsule({-0.011, -0.0875, -0.0690}, {0.011, -0.0875, -0.0690}, 0.0050, 0.014);
  parts.capsule({-0.008, -0.0870, -0.0785}, {0.008, -0.0870, -0.0785}, 0.0055, 0.009);
  // Ears, and the bone behind them.
  parts.ellipsoids({0.045, 0.017, -0.038}, {0.019, 0.024, 0.030}, 0.02);
  parts.ellipsoids({0.0715, 0.016, -0.014}, {0.0110, 0.018, 0.030}, 0.017);
  parts.ellipsoids({0.0875, 0.012, -0.014}, {0.0065, 0.009, 0.017}, 0.006, true);
  parts.set_reaches();
  return parts.all;
}

}  // namespace

std::span<const BustPart> bust_parts() {
  static const std::vector<BustPart> parts = made_parts();
  return parts;
}

Bust::Value value_of(const BustPart& part, const Vector3d& point) {
  return part.shape == PartShape::ellipsoid ? of_ellipsoid(point - part.a, part.b)
                                            : of_capsule(point - part.a, part.b - part.a, part.radius);
}

Bust::Value value_of_parts(const Vector3d& point, LeaveOut leave_out) {
  const std::span<const BustPart> parts = bust_parts();
  Bust::Value all = value_of(parts.front(), point);
  for (const BustPart& part : parts.subspan(1)) {
    if (leave_out == LeaveOut::what_is_far && (point - part.middle).squaredNorm() > part.reach_squared)
      continue;
    const Bust::Value own = value_of(part, point);
    all = part.carved ? negative(smooth_minimum(negative(all), own, part.blend))
                      : smooth_minimum(all, own, part.blend);
  }
  const Bust::Value above_cut = {point.z() - kBottom, Vector3d::UnitZ()};
  return negative(smooth_minimum(negative(all), above_cut, kEdge));
}

}  // namespace hair
