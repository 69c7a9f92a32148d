// Gives strands another number of points, and grooms another unit or fewer strands.
#pragma once

#include "hair/groom/groom.h"

namespace hair {

// `points` >= 2 points at equal distances along the line through x. Both ends stay as they are, and so does a
// point of x that is at the right place up to rounding. A line without length gives its first point and its
// last.
Eigen::VectorXd resampled(const Eigen::VectorXd& x, int points);

// The same for all strands but bald roots, and for the looks of their points.
void resample(Groom& groom, int points);

// Converts points and thicknesses to another unit.
void scale(Groom& groom, double factor);

// Keeps the first of every `every` strands.
void keep_every(Groom& groom, long every);

}  // namespace hair
