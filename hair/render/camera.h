// The camera of a picture.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>

#include "particles/vectors.h"

namespace hair {

using Eigen::Vector3d;

struct Camera {
  Vector3d eye = Vector3d(0, -1, 0), target = Vector3d::Zero(), up = Vector3d(0, 0, 1);
  double field_of_view = 0.5;  // rad, of the picture's height
};

using Bounds = Eigen::AlignedBox3d;
std::array<Vector3d, 8> corners_of(const Bounds& bounds);

// The largest part of the picture's height and width for the box.
inline constexpr double kFramed = 0.9;

// Looks at the box from `direction` (from the box to the eye; any length but 0), from as near as `aspect`
// (width / height) allows. For an empty box or a point the distance is a few millimetres. Throws
// std::invalid_argument for values that are not finite, and for an aspect that is not positive.
Camera frame_camera(const Bounds& bounds, double aspect, const Vector3d& direction = Vector3d(0.35, -1, 0.2));

// The same for points: nearer than for a box around them, because the box's corners are empty.
Camera frame_points(std::span<const Vector3d> points, double aspect,
                    const Vector3d& direction = Vector3d(0.35, -1, 0.2));

}  // namespace hair
