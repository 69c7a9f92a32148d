#include "hair/dense/parents.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "hair/dense/triangulation.h"
#include "hair/strand_synthesis.h"

namespace hair {
namespace {

// Sorts guides whose roots lie on a line of the map along this line.
std::vector<int> sorted_along(const std::vector<Vector2d>& points) {
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& point : points) middle += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vector2d& point : points) spread += (point - middle) * (point - middle).transpose();
  // The longer axis of a symmetric matrix of 2 x 2.
  const double angle = std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1)) / 2;
  const Vector2d along(std::cos(angle), std::sin(angle));
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return along.dot(points[a]) < along.dot(points[b]); });
  return order;
}

// Weights along the scalp, and the nearest guide first.
Parents weighted(const std::array<int, 3>& corners, const std::vector<RootFrame>& guides,
                 const RootFrame& child) {
  Parents parents{corners, {1, 0, 0}};
  const auto distance = [&](int guide) { return (guides[guide].position - child.position).squaredNorm(); };
  std::sort(parents.guides.begin(), parents.guides.end(),
            [&](int a, int b) { return distance(a) < distance(b) || (distance(a) == distance(b) && a < b); });
  std::array<Vector3d, 3> roots;
  for (int k = 0; k < 3; ++k) roots[k] = guides[parents.guides[k]].position;
  parents.weights = root_weights(roots, child.position);
  return parents;
}

// Among all neighbours on the line, the two whose middle is nearest.
std::array<int, 3> nearest_on_line(const std::vector<int>& line, const std::vector<RootFrame>& guides,
                                   const RootFrame& child) {
  if (line.size() == 1) return {line[0], line[0], line[0]};
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector3d middle = (guides[line[i]].position + guides[line[i + 1]].position) / 2;
    const double distance = (child.position - middle).norm();
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return {line[best], line[best + 1], line[best + 1]};
}

// The guide nearest to `place` among those that are `wanted`; -1 if there is none.
template <class Wanted>
int nearest_where(const std::vector<RootFrame>& guides, const Vector3d& place, const Wanted& wanted) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int guide = 0; guide < static_cast<int>(guides.size()); ++guide) {
    const double distance = (guides[guide].position - place).squaredNorm();
    if (distance >= least || !wanted(guide)) continue;
    least = distance;
    nearest = guide;
  }
  return nearest;
}

}  // namespace

std::vector<Parents> find_parents(const ScalpMap& map, const std::vector<RootFrame>& guides,
                                  const std::vector<RootFrame>& children) {
  std::vector<Vector2d> roots;
  for (const RootFrame& guide : guides) roots.push_back(map.at(guide.position));
  const Triangulation triangulation = triangulate(roots);
  const std::vector<int> line = triangulation.triangles.empty() ? sorted_along(roots) : std::vector<int>();
  std::vector<Parents> parents;
  parents.reserve(children.size());
  int triangle = 0;
  for (const RootFrame& child : children) {
    if (line.empty()) triangle = triangulation.triangle_at(map.at(child.position), triangle);
    parents.push_back(weighted(
        line.empty() ? triangulation.triangles[triangle].corners : nearest_on_line(line, guides, child),
        guides, child));
  }
  return parents;
}

void keep_to_side_of_parting(const std::vector<RootFrame>& guides, const std::vector<RootFrame>& children,
                             std::vector<Parents>& parents) {
  for (std::size_t i = 0; i < children.size(); ++i) {
    const RootFrame& child = children[i];
    const auto is_across = [&](int guide) { return guides[guide].side.dot(child.side) < 0; };
    Parents& own = parents[i];
    if (std::none_of(own.guides.begin(), own.guides.end(), is_across)) continue;
    Parents kept{own.guides, {}};
    int count = 0;
    for (int k = 0; k < 3; ++k)
      if (!is_across(own.guides[k])) {
        kept.guides[count] = own.guides[k];
        kept.weights[count++] = own.weights[k];
      }
    if (count == 0) {
      const int nearest = nearest_where(guides, child.position, [&](int guide) { return !is_across(guide); });
      if (nearest < 0) continue;
      kept.guides[count++] = nearest;
    }
    const double sum = kept.weights[0] + kept.weights[1] + kept.weights[2];
    for (double& weight : kept.weights) weight = sum > 0 ? weight / sum : 0;
    if (!(sum > 0)) kept.weights[0] = 1;
    for (int k = count; k < 3; ++k) kept.guides[k] = kept.guides[0];
    own = kept;
  }
}

}  // namespace hair
