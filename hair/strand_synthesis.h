// H10. Strand synthesis: a few hundred guides are simulated, and many thousand strands are drawn. A strand
// between guides is interpolated from three of them; a strand of a wisp is extrapolated from one; a blend of
// both is interpolated at its root and extrapolated at its tip. Sources: the lecture, "Rendering",
// "Interpolation" and "Extrapolation"; J. T. Chang, J. Jin, Y. Yu, "A Practical Model for Hair Mutual
// Interactions" (SCA 2002); frames: R. L. Bishop, "There is More than One Way to Frame a Curve" (1975).
//
// All guides of a call and the strand that is made of them, `child`, have n >= 2 points, 3n numbers, m. Good
// solutions allocate nothing. Errors of points are at most 1e-12 of the input coordinates, in any unit: only
// the length 0 counts as too short.
#pragma once

#include <array>
#include <vector>

#include "hair/root_frame.h"
#include "particles/vectors.h"

namespace hair {

using Eigen::Matrix3d;
using particles::Input;
using particles::Output;

// A guide as it lies now. Its root's frame has the guide's first point as `position` and the scalp's outward
// normal as `axis`, whatever direction the hair leaves in. Axis, side and axis x side are perpendicular, of
// length 1, and move with the scalp.
struct GuideHair {
  RootFrame root;
  Eigen::Map<const Eigen::VectorXd> points;  // 3n, m
};

// Frames that follow a guide without twist, one for each of its n points.
struct GuideFrames {
  Eigen::VectorXd arc;          // 0 at the root, 1 at the tip
  std::vector<Matrix3d> turns;  // rotations: 1 at the root
};

// (1) The weights of the point of a triangle that is nearest to `root`:
//
//   nearest = w_0 corner_0 + w_1 corner_1 + w_2 corner_2,    w_k >= 0,    w_0 + w_1 + w_2 = 1
//
// If the root is above or below the triangle, that is its projection into the triangle's plane; else it lies
// on an edge or at a corner. Errors, if the triangle's height on its longest edge is at least a hundredth of
// that edge: 1e-12 for the sum, 1e-10 of the edge for the point. Thinner triangles, down to a line and a
// single point, have no unique weights: any weights are right whose sum is 1 to 1e-6, and whose point is at
// most 1e-6 of the longest edge farther from `root` than the nearest point.
std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root);

// (2) Interpolation, point by point, with each guide in the coordinates of its root's frame. If A has the
// columns axis, side and axis x side of a root's frame, then
//
//   child_i = position + A sum over k of w_k A_k^T (points_ki - position_k)
//
// Symbols without an index belong to `root`, where the child grows. The weights are those of (1).
void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child);

// (3) The frames of a guide that (4) and (5) need, calculated once for all its children. guide: 3n numbers;
// `frames` comes with n numbers and n matrices.
//
//   arc_i   = the length from the root to point i, over the guide's length; 0 if that is 0
//   turns_0 = turns_1 = 1,    turns_i = R_i turns_(i-1)
//
// R_i turns the direction u_(i-1), from point i - 2 to point i - 1, into u_i, from point i - 1 to point i,
// about the axis perpendicular to both: it is the smallest such rotation, so frames do not twist. Points that
// coincide have no direction: R_i = 1, and u_i = u_(i-1); before the first direction all turns are 1. If the
// guide reverses, u_i = -u_(i-1) up to rounding, R_i is a half turn about any axis perpendicular to u_i.
//
// Errors: 1e-12 of arc; 1e-10 of turns, 1e-6 where an R_i turns by more than 175 degrees.
void carry_along(Input guide, GuideFrames& frames);

// (4) Extrapolation: a strand of the guide's wisp, which grows at `root` (m). The vector between the two
// roots turns with the guide's frame, and its length at the tip is `spread` >= 0 times that at the root:
//
//   child_i = guide_i + (1 + (spread - 1) arc_i) turns_i (root - guide_0)
//
// frames: (3) of this guide.
void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child);

// (5) Neighbours agree near their roots, and wisps separate at their tips:
//
//   child_i = (1 - w) at_root_i + w at_tip_i,    w = arc_i^2 (3 - 2 arc_i)
//
// arc: n numbers, those of (3). at_root, at_tip: two strands of n points. `child` may be one of these two.
void blend(Input arc, Input at_root, Input at_tip, Output child);

}  // namespace hair
