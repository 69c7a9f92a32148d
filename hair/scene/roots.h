// Where strands grow: roots on a line, a disc, a head.
#pragma once

#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// `side` for a strand along `axis` (of length 1): x made perpendicular to it, or y where x is too near it.
Vector3d side_of(const Vector3d& axis);

// From `from` to `to`, both included, at equal distances. count >= 1; one alone is in the middle.
std::vector<Vector3d> points_on_line(const Vector3d& from, const Vector3d& to, int count);

// Spread evenly over a disc, on the spiral of a sunflower's seeds: H. Vogel, "A better way to construct the
// sunflower head", Mathematical Biosciences 44 (1979). normal: of length 1.
std::vector<Vector3d> points_on_disc(const Vector3d& centre, const Vector3d& normal, double radius,
                                     int count);

// Spread evenly over the part of a unit sphere that is at most `angle` (0 to pi) from `axis`, on the same
// spiral.
std::vector<Vector3d> directions_in_cap(const Vector3d& axis, double angle, int count);

// The way that a hair on a head leaves it: between `outward` and the way that it is combed, along the head.
// `lift` from 0 (flat) to 1 (straight out). All of length 1 but `comb`; where that is along `outward`,
// outward it is.
Vector3d combed(const Vector3d& outward, const Vector3d& comb, double lift);

}  // namespace hair
