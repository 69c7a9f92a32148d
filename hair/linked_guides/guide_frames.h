// The frames and the tangents of a guide's particles, for links and strips.
#pragma once

#include <span>

#include "particles/vectors.h"

namespace hair {

// frames[0] has the columns tangent, normal, tangent x normal. A particle's direction is that from the root
// to it, and the root's is the tangent. From particle to particle the least rotation takes one direction to
// the next, so frames do not twist (R. L. Bishop, "There is More than One Way to Frame a Curve", 1975). If a
// particle meets the root, its frame does not turn. tangent, normal: of length 1, perpendicular. x: 3n
// numbers, frames: n.
//
// Directions of single segments would turn with a hair's smallest wave, and move the end of a link's arm,
// which is many segments long.
void guide_frames(particles::Input x, const Eigen::Vector3d& tangent, const Eigen::Vector3d& normal,
                  std::span<Eigen::Matrix3d> frames);

// Each tangent is the direction from the previous to the next particle, of length 1; 0 if they coincide. 3n
// numbers.
void guide_tangents(particles::Input x, particles::Output tangents);

}  // namespace hair
