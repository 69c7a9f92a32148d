#include "hair/obstacles/obstacles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hair/obstacles/meeting.h"
#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_finite, particles::require_positive;

namespace {

// The surface of a round object. `fallback` is the normal for its middle.
Surface round_surface(const Vector3d& from_middle, double radius, const Vector3d& fallback) {
  const double distance = from_middle.norm();
  if (distance == 0) return {-radius, fallback};
  return {distance - radius, from_middle / distance};
}

Surface surface_of(const Plane& plane, const Vector3d& point) {
  return {plane.normal.dot(point - plane.point), plane.normal};
}

Surface surface_of(const Sphere& sphere, const Vector3d& point) {
  return round_surface(point - sphere.centre, sphere.radius, Vector3d::UnitZ());
}

Surface surface_of(const Capsule& capsule, const Vector3d& point) {
  const Vector3d axis = capsule.b - capsule.a;
  const double squared = axis.squaredNorm();
  const double along = squared > 0 ? std::clamp(axis.dot(point - capsule.a) / squared, 0.0, 1.0) : 0;
  return round_surface(point - (capsule.a + along * axis), capsule.radius,
                       squared > 0 ? axis.unitOrthogonal() : Vector3d(Vector3d::UnitZ()));
}

Surface surface_of(const PlacedSolid& placed, const Vector3d& point) {
  const auto [distance, normal] = placed.solid->surface_at(placed.rotation.conjugate() * (point - placed.at));
  return {distance, placed.rotation * normal};
}

void check_point(const char* what, const Vector3d& point) {
  for (double value : point) require_finite(what, value);
}

void check_shape(const Plane& plane) {
  check_point("a plane's point", plane.point);
  const double length = plane.normal.norm();
  require(std::abs(length - 1) <= 1e-9, "the length of a plane's normal", length, "1");
}

void check_shape(const Sphere& sphere) {
  check_point("a sphere's centre", sphere.centre);
  require_positive("a sphere's radius", sphere.radius);
}

void check_shape(const Capsule& capsule) {
  check_point("a capsule's end", capsule.a);
  check_point("a capsule's end", capsule.b);
  require_positive("a capsule's radius", capsule.radius);
}

void check_shape(const PlacedSolid& placed) {
  if (!placed.solid) throw std::invalid_argument("a placed solid without a solid; give one");
  check_point("a solid's place", placed.at);
  check_point("a solid's angular velocity", placed.angular_velocity);
  const double length = placed.rotation.norm();
  require(std::abs(length - 1) <= 1e-9, "the length of a solid's rotation", length, "1");
}

struct MoveBy {
  Vector3d way;

  void operator()(Plane& plane) const { plane.point += way; }
  void operator()(Sphere& sphere) const { sphere.centre += way; }
  void operator()(Capsule& capsule) const { capsule = {capsule.a + way, capsule.b + way, capsule.radius}; }
  void operator()(PlacedSolid& placed) const { placed.at += way; }
};

// The part of a vector that friction removes: its part across n, at most `limit` of it.
Vector3d friction(const Vector3d& vector, const Vector3d& n, double limit) {
  const Vector3d across = vector - n.dot(vector) * n;
  const double length = across.norm();
  return length <= limit ? across : Vector3d(limit / length * across);
}

// The largest depth that rounding alone may leave for a point that was pushed out of an obstacle.
double rounding(const Vector3d& point) {
  return 1e-14 * (1 + point.cwiseAbs().maxCoeff());
}

// A particle this near to a surface at a step's start slides on it; it may cut off a part of a round object.
constexpr double kTouching = 1e-6;  // m
constexpr double kCutOff = 0.5;     // up to 60 degrees of it

bool is_inside(const Obstacle& obstacle, const Vector3d& point) {
  return surface_at(obstacle, point).distance < -rounding(point);
}

// The contact of a particle that passes through an obstacle in a step, instead of into it: at its end another
// surface is nearer than the one that it met. `way`: the particle's displacement to x, in the obstacle's
// frame; `end`: the surface at x. Nothing if it was inside an obstacle, or another one is in the way.
std::optional<Meeting> passes(const std::vector<Obstacle>& obstacles, const Obstacle& obstacle, double h,
                              const Vector3d& x, const Vector3d& way, const Surface& end) {
  if (!(end.normal.dot(way) > 0) || end.distance > way.norm()) return {};
  const Vector3d from = x - way, at_rest = from - h * velocity_at(obstacle, x);
  const auto meeting = first_meeting(obstacle, from, x);
  if (!meeting) return {};
  if (surface_at(obstacle, from).distance <= kTouching && meeting->normal.dot(end.normal) >= kCutOff)
    return {};
  for (const Obstacle& any : obstacles)
    if (is_inside(any, at_rest + h * velocity_at(any, at_rest)) ||
        (&any != &obstacle && is_inside(any, meeting->point)))
      return {};
  return meeting;
}

}  // namespace

Surface surface_at(const Obstacle& obstacle, const Vector3d& point) {
  return std::visit([&](const auto& shape) { return surface_of(shape, point); }, obstacle.shape);
}

Vector3d velocity_at(const Obstacle& obstacle, const Vector3d& point) {
  const auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape);
  if (!placed) return obstacle.velocity;
  return obstacle.velocity + placed->angular_velocity.cross(point - placed->at);
}

void check_obstacle(const Obstacle& obstacle) {
  std::visit([](const auto& shape) { check_shape(shape); }, obstacle.shape);
  require_at_least("an obstacle's friction", obstacle.friction, 0);
  check_point("an obstacle's velocity", obstacle.velocity);
}

void move_obstacle(Obstacle& obstacle, double h) {
  std::visit(MoveBy{h * obstacle.velocity}, obstacle.shape);
  if (auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape)) {
    const double angle = h * placed->angular_velocity.norm();
    if (angle > 0)
      placed->rotation =
          (Eigen::AngleAxisd(angle, placed->angular_velocity.normalized()) * placed->rotation).normalized();
  }
}

CollisionReport collide(const std::vector<Obstacle>& obstacles, const particles::Particles& particles,
                        double h, particles::Input x_before, particles::State& state) {
  CollisionReport report;
  for (int i = 0; i < particles.count(); ++i) {
    if (particles.is_pinned(i)) continue;
    auto x = state.x.segment<3>(3 * i), v = state.v.segment<3>(3 * i);
    double deepest = 0;
    for (int pass = 0; pass < kMostCollisionPasses; ++pass) {
      deepest = 0;
      for (const Obstacle& obstacle : obstacles) {
        const Surface surface = surface_at(obstacle, x);
        double depth = -surface.distance;
        Vector3d n = surface.normal;
        const Vector3d velocity = velocity_at(obstacle, x);
        const Vector3d way = x - x_before.segment<3>(3 * i) - h * velocity;
        if (pass == 0)
          if (const auto meeting = passes(obstacles, obstacle, h, x, way, surface)) {
            n = meeting->normal;
            depth = n.dot(meeting->point - x);
          }
        if (!(depth > 0)) continue;
        deepest = std::max(deepest, depth);

        x += depth * n - friction(way, n, obstacle.friction * depth);

        const Vector3d u = v - velocity;
        const double speed = -n.dot(u);
        if (!(speed > 0)) continue;
        const Vector3d change = speed * n - friction(u, n, obstacle.friction * speed);
        v += change;
        const Vector3d impulse = particles.mass[i] * change;
        report.impulse += impulse;
        report.work += impulse.dot(velocity);
      }
      if (pass == 0 && deepest > 0) {
        ++report.contacts;
        report.deepest = std::max(report.deepest, deepest);
      }
      if (deepest <= rounding(x)) break;
    }
    if (deepest <= rounding(x)) continue;
    for (const Obstacle& obstacle : obstacles)
      report.penetration = std::max(report.penetration, -surface_at(obstacle, x).distance);
  }
  return report;
}

}  // namespace hair
