// The shape that a hair has at rest: straight, wavy or curly.
//
// Particles lie on a smooth curve at equal distances along it, length / segments each; the distances of
// neighbours, which strand_from_rest takes for rest lengths, are a little less where the curve bends. All
// three throw std::invalid_argument for what is out of bounds, and a curve that its segments can't follow is:
// they must be at most a quarter of a wave or turn.
#pragma once

#include "particles/vectors.h"

namespace hair {

using Eigen::Vector3d;

// Where the curve begins and which way it goes. axis and side have length 1 and are perpendicular.
struct RootFrame {
  Vector3d position = Vector3d::Zero();  // m
  Vector3d axis = Vector3d(0, 0, -1);
  Vector3d side = Vector3d(1, 0, 0);
};

struct RestShape {
  Eigen::VectorXd x;  // 3(segments + 1), m; begins with the frame's position
  Vector3d tangent;   // of the curve at its root: what a clamped strand's root_tangent is
  Vector3d normal;    // perpendicular to the tangent, in the plane of tangent and side
};

// A straight line along the axis.
RestShape straight_shape(int segments, double length, const RootFrame& frame);

// A planar wave around the axis, t axis + amplitude sin(2 pi t / wavelength) side, 0 <= amplitude <=
// wavelength.
RestShape wavy_shape(int segments, double length, double amplitude, double wavelength,
                     const RootFrame& frame);

// How far along the axis that wave is, m, where its length is s >= 0.
double wave_axis(double amplitude, double wavelength, double s);

// A right-handed helix: turns of `radius` >= 0, which advance along the axis by `pitch` > 0 each. The helix's
// own axis goes past the root at -radius * side. Its curvature is r / (r^2 + c^2) and its torsion c / (r^2 +
// c^2), with c = pitch / 2 pi.
RestShape curly_shape(int segments, double length, double radius, double pitch, const RootFrame& frame);

}  // namespace hair
