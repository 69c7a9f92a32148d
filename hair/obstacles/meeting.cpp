#include "hair/obstacles/meeting.h"

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

// The smallest s >= 0 with |from + s way| = radius, if the way enters the ball there; vectors are from the
// middle.
std::optional<double> enters(const Vector3d& from, const Vector3d& way, double radius) {
  const double squared = way.squaredNorm(), half = from.dot(way);
  const double root = half * half - squared * (from.squaredNorm() - radius * radius);
  if (!(half < 0) || !(root > 0)) return {};
  return std::max(0.0, (-half - std::sqrt(root)) / squared);
}

std::optional<double> share_of_way(const Plane&, const Vector3d&, const Vector3d&) {
  return {};
}

std::optional<double> share_of_way(const Sphere& sphere, const Vector3d& from, const Vector3d& way) {
  return enters(from - sphere.centre, way, sphere.radius);
}

// The capsule's round side between the ends, or the sphere at one of them: the first one on the way.
std::optional<double> share_of_way(const Capsule& capsule, const Vector3d& from, const Vector3d& way) {
  std::optional<double> first = enters(from - capsule.a, way, capsule.radius);
  const auto take = [&](std::optional<double> other) {
    if (other && !(first && *first <= *other)) first = other;
  };
  take(enters(from - capsule.b, way, capsule.radius));
  const Vector3d axis = capsule.b - capsule.a;
  const double squared = axis.squaredNorm();
  if (squared == 0) return first;
  const auto across = [&](const Vector3d& vector) -> Vector3d {
    return vector - axis.dot(vector) / squared * axis;
  };
  const auto side = enters(across(from - capsule.a), across(way), capsule.radius);
  if (!side) return first;
  const double along = axis.dot(from + *side * way - capsule.a);
  if (along >= 0 && along <= squared) take(side);
  return first;
}

// Advances by half of the distance, as long as this ends outside, and searches more finely when a step ends
// below the surface.
std::optional<double> share_of_way(const PlacedSolid& placed, const Vector3d& from, const Vector3d& way) {
  constexpr double shortest = 1e-3;  // m: thinner parts may be missed
  const Eigen::Quaterniond back = placed.rotation.conjugate();
  const Vector3d start = back * (from - placed.at), along = back * way;
  const double length = along.norm();
  double outside = 0, ahead = 0;
  while (true) {
    const double distance = placed.solid->surface_at(start + ahead * along).distance;
    if (distance < 0 && ahead > 0) break;
    if (ahead >= 1) return {};
    outside = ahead;
    ahead = std::min(1.0, ahead + std::max(shortest, 0.5 * distance) / length);
  }
  double inside = ahead;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (outside + inside);
    (placed.solid->surface_at(start + middle * along).distance < 0 ? inside : outside) = middle;
  }
  return outside;
}

}  // namespace

std::optional<Meeting> first_meeting(const Obstacle& obstacle, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  const auto share =
      std::visit([&](const auto& shape) { return share_of_way(shape, from, way); }, obstacle.shape);
  if (!share || *share > 1) return {};
  const Vector3d point = from + *share * way;
  return Meeting{point, surface_at(obstacle, point).normal};
}

}  // namespace hair
