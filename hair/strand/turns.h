// Turns in space as vectors: along the axis, as long as the angle in rad.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hair {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Eigen::Quaterniond turn_by(const Vector3d& angle);

// theta of a unit quaternion, at most pi long.
Vector3d turn_of(const Eigen::Quaterniond& q);

// A: while the object turned by theta continues to turn with the angular velocity w, along the axes of the
// world, theta' = A w. The formula is in hair/rigid_links/tree_system.h.
Matrix3d rate_of_turn(const Vector3d& theta);

// The smallest turn that takes the direction of `from` to that of `to`, of any lengths: quaternion
// (cos(angle/2), sin(angle/2) axis). For opposite directions: half a turn about an axis perpendicular to
// `from`. Eigen's FromTwoVectors finds that axis by a singular value decomposition, which takes seven seconds
// to compile in each source.
Eigen::Quaterniond turn_between(const Vector3d& from, const Vector3d& to);

// The axes with this z and this x, which have length 1 and are perpendicular.
Eigen::Quaterniond root_axes(const Vector3d& tangent, const Vector3d& normal);

}  // namespace hair
