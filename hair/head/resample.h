// Strands with another number of points.
#pragma once

#include "hair/head/groom.h"

namespace hair {

// `points` >= 2 points of the line through x at equal distances along it. Both ends are kept as they are, and
// so is a point of x that is there but for rounding: points that are at equal distances already stay. A line
// without length gives its first point and its last.
Eigen::VectorXd resampled(const Eigen::VectorXd& x, int points);

// The same for all strands but bald roots, and for what they look like at their points.
void resample(Groom& groom, int points);

}  // namespace hair
