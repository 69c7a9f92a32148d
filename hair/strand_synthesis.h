// H10. Strand synthesis: a few hundred guides are simulated, and many thousand strands are drawn. A strand
// between guides is interpolated from three of them; a strand of a wisp is extrapolated from one; a blend of
// both is interpolated at its root and extrapolated at its tip. Sources: the lecture, "Rendering",
// "Interpolation" and "Extrapolation"; J. T. Chang, J. Jin, Y. Yu, "A Practical Model for Hair Mutual
// Interactions" (SCA 2002); frames: R. L. Bishop, "There is More than One Way to Frame a Curve" (1975).
//
// All guides of a call and the strand that is made of them, `child`, have n >= 2 points, 3n numbers, m. Good
// solutions allocate nothing. Errors of points are at most 1e-12 of the coordinates that they are made of, in
// any unit: no length but 0 is too short.
#pragma once

#include <array>
#include <vector>

#include "hair/root_frame.h"
#include "particles/vectors.h"

namespace hair {

using Eigen::Matrix3d;
using particles::Input;
using particles::Output;

// A guide as it lies now. Of its root's frame, `position` is its first point and `axis` the scalp's outward
// normal, whatever direction the hair leaves it in. Axis, side and axis x side are perpendicular, of length
// 1, and move with the scalp.
struct GuideHair {
  RootFrame root;
  Eigen::Map<const Eigen::VectorXd> points;  // 3n, m
};

// What is carried along a guide, of each of its n points.
struct GuideFrames {
  Eigen::VectorXd arc;          // 0 at the root, 1 at the tip
  std::vector<Matrix3d> turns;  // rotations: 1 at the root
};

// (1) The weights of the point that is nearest to `root` of all points of a triangle:
//
//   nearest = w_0 corner_0 + w_1 corner_1 + w_2 corner_2,    w_k >= 0,    w_0 + w_1 + w_2 = 1
//
// Above or below the triangle that is the root's projection into its plane; outside it lies on an edge or at
// a corner. Errors, if the triangle's height on its longest edge is a hundredth of that edge or more: 1e-12
// of the sum, 1e-10 of the edge. Thinner ones, down to a line and a single point, have no unique weights: any
// are right whose sum is 1 to 1e-6, and that leave the point at most 1e-6 of the longest edge farther from
// `root` than it could be.
std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root);

// (2) Interpolation, point by point, each guide as its root's frame sees it. Where A has the columns axis,
// side and axis x side of a root's frame,
//
//   child_i = position + A sum over k of w_k A_k^T (points_ki - position_k)
//
// without an index: of `root`, where the child grows. The weights are given as (1) has them.
void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child);

// (3) What (4) and (5) need of a guide, once for all its children. guide: 3n numbers; `frames` comes with n
// numbers and n matrices.
//
//   arc_i   = the length from the root to point i, over the guide's length; 0 if that is 0
//   turns_0 = turns_1 = 1,    turns_i = R_i turns_(i-1)
//
// R_i turns the direction u_(i-1), from point i - 2 to point i - 1, into u_i, from point i - 1 to point i,
// about the axis that is perpendicular to both: no rotation does it with less. So a frame goes along without
// twist. Points that coincide have no direction: R_i = 1, and u_i = u_(i-1); before the first direction all
// turns are 1. Where the guide turns right round, u_i = -u_(i-1) but for rounding, R_i is a half turn about
// any axis across it.
//
// Errors: 1e-12 of arc; 1e-10 of turns, if no R_i turns by more than 175 degrees.
void carry_along(Input guide, GuideFrames& frames);

// (4) Extrapolation: a strand of the guide's wisp, which grows at `root` (m). What is between their roots
// goes along with the guide, and grows to `spread` >= 0 times its length at the tip:
//
//   child_i = guide_i + (1 + (spread - 1) arc_i) turns_i (root - guide_0)
//
// frames: (3) of this guide.
void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child);

// (5) Neighbours agree near their roots, and wisps part at their tips:
//
//   child_i = (1 - w) at_root_i + w at_tip_i,    w = arc_i^2 (3 - 2 arc_i)
//
// arc: n numbers, those of (3). at_root, at_tip: two strands of n points. `child` may be one of these two.
void blend(Input arc, Input at_root, Input at_tip, Output child);

}  // namespace hair
