// The frames and the tangents of a guide's particles, which links and strips refer to.
#pragma once

#include <span>

#include "particles/vectors.h"

namespace hair {

// frames[0] has the columns tangent, normal, tangent x normal. The direction of a particle is that from the
// root to it, the root's is the tangent; from particle to particle the least rotation takes one direction to
// the next, so that frames go along without twist (R. L. Bishop, "There is More than One Way to Frame a
// Curve", 1975). Where a particle meets the root nothing turns. tangent, normal: of length 1, perpendicular.
// x: 3n numbers, frames: n.
//
// Directions of segments would turn by as much as a hair's smallest wave does, and a link's arm, many
// segments long, with them.
void guide_frames(particles::Input x, const Eigen::Vector3d& tangent, const Eigen::Vector3d& normal,
                  std::span<Eigen::Matrix3d> frames);

// The direction from the particle before to the particle after each one, of length 1; 0 if they coincide. 3n
// numbers.
void guide_tangents(particles::Input x, particles::Output tangents);

}  // namespace hair
