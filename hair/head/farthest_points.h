// Some of many points, well spread: each is as far as can be from those that were taken before it. T. F.
// Gonzalez, "Clustering to minimize the maximum intercluster distance" (Theoretical Computer Science 38,
// 1985): no other choice leaves all points within less than half of the distance that this one does.
#pragma once

#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// Of so many points at most each is looked at; of more, every so many.
inline constexpr std::size_t kMostLookedAt = 100'000;

// The indices of `count` of them, rising; all of them if there are no more. The first to be taken is the one
// that is nearest to the middle. Its time grows with count times the points.
std::vector<std::size_t> farthest_points(const std::vector<Vector3d>& points, std::size_t count);

}  // namespace hair
