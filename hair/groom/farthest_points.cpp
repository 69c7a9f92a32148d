#include "hair/groom/farthest_points.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace hair {

std::vector<std::size_t> farthest_points(const std::vector<Vector3d>& points, std::size_t count) {
  std::vector<std::size_t> taken;
  if (count >= points.size()) {
    taken.resize(points.size());
    std::iota(taken.begin(), taken.end(), std::size_t{0});
    return taken;
  }
  const std::size_t most = std::max(kMostLookedAt, count), every = (points.size() + most - 1) / most;
  std::vector<std::size_t> looked_at;
  for (std::size_t i = 0; i < points.size(); i += every) looked_at.push_back(i);
  Vector3d middle = Vector3d::Zero();
  for (const std::size_t i : looked_at) middle += points[i] / static_cast<double>(looked_at.size());
  const auto nearer = [&](std::size_t a, std::size_t b) {
    return (points[a] - middle).squaredNorm() < (points[b] - middle).squaredNorm();
  };
  std::size_t next = *std::min_element(looked_at.begin(), looked_at.end(), nearer);
  std::vector<double> distances(looked_at.size(), std::numeric_limits<double>::infinity());
  while (taken.size() < std::min(count, looked_at.size())) {
    taken.push_back(next);
    std::size_t farthest = 0;
    for (std::size_t k = 0; k < looked_at.size(); ++k) {
      distances[k] = std::min(distances[k], (points[looked_at[k]] - points[taken.back()]).squaredNorm());
      if (distances[k] > distances[farthest]) farthest = k;
    }
    // All other points coincide with chosen ones.
    if (!(distances[farthest] > 0)) break;
    next = looked_at[farthest];
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

}  // namespace hair
