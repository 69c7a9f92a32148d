// The rest shape of a hair: straight, wavy or curly.
//
// Particles lie on a smooth curve at equal arc lengths, length / segments each. The distances of
// neighbours, which strand_from_rest uses as rest lengths, are slightly smaller where the curve bends. All
// three functions throw std::invalid_argument for values out of bounds, and if segments are longer than a
// quarter of a wave or turn, because they can't follow the curve then.
#pragma once

#include "hair/root_frame.h"
#include "particles/vectors.h"

namespace hair {

// The side of a strand along `axis` (of length 1): x made perpendicular to it, or y if x is nearly parallel
// to it.
Vector3d side_of(const Vector3d& axis);

struct RestShape {
  Eigen::VectorXd x;  // 3(segments + 1), m; starts with the frame's position
  Vector3d tangent;   // the curve's tangent at its root: the root_tangent of a clamped strand
  Vector3d normal;    // perpendicular to the tangent, in the plane of tangent and side
};

// A straight line along the axis.
RestShape straight_shape(int segments, double length, const RootFrame& frame);

// A planar wave around the axis, t axis + amplitude sin(2 pi t / wavelength) side, 0 <= amplitude <=
// wavelength.
RestShape wavy_shape(int segments, double length, double amplitude, double wavelength,
                     const RootFrame& frame);

// The position along the axis, m, at the arc length s >= 0 of that wave.
double wave_axis(double amplitude, double wavelength, double s);

// A right-handed helix: turns of `radius` >= 0, each of which advances along the axis by `pitch` > 0. The
// helix's own axis passes the root at -radius * side. Its curvature is r / (r^2 + c^2) and its torsion c /
// (r^2 + c^2), with c = pitch / 2 pi.
RestShape curly_shape(int segments, double length, double radius, double pitch, const RootFrame& frame);

}  // namespace hair
