#include "hair/dense/roots_between.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "hair/dense/scalp_map.h"
#include "hair/dense/triangulation.h"
#include "hair/strand/variation.h"

namespace hair {

namespace {

constexpr std::size_t kMostCorners = 20'000;
constexpr double kLongestSide = 3;  // over the median of triangles' longest sides

using Corners = std::array<const RootFrame*, 3>;

double longest_side(const Corners& triangle) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (triangle[k]->position - triangle[(k + 1) % 3]->position).norm());
  return longest;
}

double area_of(const Corners& triangle) {
  const Vector3d& at = triangle[0]->position;
  return (triangle[1]->position - at).cross(triangle[2]->position - at).norm() / 2;
}

std::vector<Corners> triangles_of(const std::vector<RootFrame>& scalp) {
  const ScalpMap map(scalp);
  std::vector<Vector2d> places;
  for (const RootFrame& root : scalp) places.push_back(map.at(root.position));
  std::vector<Corners> triangles;
  std::vector<double> sides;
  for (const Triangulation::Triangle& found : triangulate(places).triangles) {
    triangles.push_back({});
    for (std::size_t k = 0; k < 3; ++k)
      triangles.back()[k] = &scalp[static_cast<std::size_t>(found.corners[k])];
    sides.push_back(longest_side(triangles.back()));
  }
  if (triangles.empty()) return {};
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  std::nth_element(sides.begin(), middle, sides.end());
  std::erase_if(triangles, [longest = kLongestSide * *middle](const Corners& triangle) {
    return longest_side(triangle) > longest;
  });
  return triangles;
}

RootFrame root_in(const Corners& triangle, Variation& variation) {
  // Evenly over a triangle: the root of a uniform number is the distance from the first corner.
  const double far = std::sqrt(variation.uniform(0, 1)), along = variation.uniform(0, 1);
  const std::array<double, 3> weights = {1 - far, far * (1 - along), far * along};
  RootFrame root{Vector3d::Zero(), Vector3d::Zero(), {}};
  for (std::size_t k = 0; k < 3; ++k) {
    root.position += weights[k] * triangle[k]->position;
    root.axis += weights[k] * triangle[k]->axis;
  }
  root.axis = root.axis.norm() > 1e-6 ? root.axis.normalized() : triangle[0]->axis;
  root.side = side_of(root.axis);
  return root;
}

}  // namespace

std::vector<RootFrame> roots_between(const std::vector<RootFrame>& scalp, int count, std::uint64_t seed) {
  std::vector<RootFrame> corners;
  const std::size_t every = (scalp.size() + kMostCorners - 1) / kMostCorners;
  for (std::size_t i = 0; i < scalp.size(); i += every) corners.push_back(scalp[i]);
  if (corners.empty()) return {};
  const std::vector<Corners> triangles = triangles_of(corners);
  double all = 0;
  for (const Corners& triangle : triangles) all += area_of(triangle);
  if (!(all > 0)) return {};
  std::vector<RootFrame> roots;
  roots.reserve(static_cast<std::size_t>(count));
  double until = 0;
  for (const Corners& triangle : triangles) {
    until += area_of(triangle);
    while (static_cast<int>(roots.size()) < count &&
           (static_cast<double>(roots.size()) + 0.5) * all <= until * count) {
      Variation own(seed, roots.size());
      roots.push_back(root_in(triangle, own));
    }
  }
  // Roots that are missing because the areas' sum is rounded.
  while (static_cast<int>(roots.size()) < count) {
    Variation own(seed, roots.size());
    roots.push_back(root_in(triangles.back(), own));
  }
  return roots;
}

}  // namespace hair
