#include "hair/obstacles/meeting.h"

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

std::optional<double> share_of_way(const Plane&, const Vector3d&, const Vector3d&) {
  return {};
}

// The smallest s >= 0 at which from + s way is on the sphere, if the way enters there.
std::optional<double> share_of_way(const Sphere& sphere, const Vector3d& start, const Vector3d& way) {
  const Vector3d from = start - sphere.centre;
  const double squared = way.squaredNorm(), half = from.dot(way);
  const double root = half * half - squared * (from.squaredNorm() - sphere.radius * sphere.radius);
  if (!(half < 0) || !(root > 0)) return {};
  return std::max(0.0, (-half - std::sqrt(root)) / squared);
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
