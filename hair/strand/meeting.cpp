#include "hair/strand/meeting.h"

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

// The smallest s >= 0 with |from + s way| = radius, of vectors from something round's middle, if the way enters there.
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

// Its round side between the ends, or the sphere at one of them: whichever comes first.
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
