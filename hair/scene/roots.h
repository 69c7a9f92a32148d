// Places roots: on a line, a disc, a head.
#pragma once

#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// From `from` to `to`, both included, equally spaced. count >= 1; a single point is in the middle.
std::vector<Vector3d> points_on_line(const Vector3d& from, const Vector3d& to, int count);

// Evenly distributed over a disc, on the spiral of a sunflower's seeds: H. Vogel, "A better way to construct
// the sunflower head", Mathematical Biosciences 44 (1979). normal: of length 1.
std::vector<Vector3d> points_on_disc(const Vector3d& centre, const Vector3d& normal, double radius,
                                     int count);

// Evenly distributed over the part of a unit sphere within `angle` (0 to pi) of `axis`, on the same spiral.
std::vector<Vector3d> directions_in_cap(const Vector3d& axis, double angle, int count);

}  // namespace hair
