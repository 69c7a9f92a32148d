// Where a particle's path first meets an obstacle: a fast one may pass through between two steps.
#pragma once

#include <optional>

#include "hair/strand/obstacles.h"

namespace hair {

// The obstacle touches this plane there.
struct Meeting {
  Vector3d point, normal;  // m; from the obstacle, of length 1
};

// The path is straight, from `from` to `to`, in the frame of the obstacle, and begins outside or on the
// surface. Nothing if it does not enter, and for planes: nobody gets to the other side of one.
std::optional<Meeting> first_meeting(const Obstacle& obstacle, const Vector3d& from, const Vector3d& to);

}  // namespace hair
