// Chooses some of many points, well spread: each is as far as possible from those chosen before it. T. F.
// Gonzalez, "Clustering to minimize the maximum intercluster distance" (Theoretical Computer Science 38,
// 1985): no choice has less than half of this one's largest distance from a point to the nearest chosen
// point.
#pragma once

#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// If there are more points than this, only every k-th one is looked at.
inline constexpr std::size_t kMostLookedAt = 100'000;

// The indices of `count` of them, ascending; of all, if there are no more. The first chosen point is the one
// nearest to the middle. The time grows with count times the points.
std::vector<std::size_t> farthest_points(const std::vector<Vector3d>& points, std::size_t count);

}  // namespace hair
