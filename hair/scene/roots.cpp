#include "hair/scene/roots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hair {

namespace {

// The golden angle: the turn from one point on the spiral to the next.
const double kGolden = std::numbers::pi * (3 - std::sqrt(5.0));

}  // namespace

std::vector<Vector3d> points_on_line(const Vector3d& from, const Vector3d& to, int count) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i)
    points.push_back(from + (count == 1 ? 0.5 : static_cast<double>(i) / (count - 1)) * (to - from));
  return points;
}

std::vector<Vector3d> points_on_disc(const Vector3d& centre, const Vector3d& normal, double radius,
                                     int count) {
  const Vector3d x = side_of(normal), y = normal.cross(x);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double r = radius * std::sqrt((i + 0.5) / count), angle = i * kGolden;
    points.push_back(centre + r * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return points;
}

std::vector<Vector3d> directions_in_cap(const Vector3d& axis, double angle, int count) {
  const Vector3d x = side_of(axis), y = axis.cross(x);
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    // Equal heights have equal areas (Archimedes).
    const double height = 1 - (1 - std::cos(angle)) * (i + 0.5) / count;
    const double across = std::sqrt(std::max(0.0, 1 - height * height)), turn = i * kGolden;
    directions.push_back((height * axis + across * (std::cos(turn) * x + std::sin(turn) * y)).normalized());
  }
  return directions;
}

}  // namespace hair
