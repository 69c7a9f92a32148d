// Finds where a particle's path first meets an obstacle: a fast one may pass through it in one step.
#pragma once

#include <optional>

#include "hair/obstacles/obstacles.h"

namespace hair {

// The plane that touches the obstacle at the contact.
struct Meeting {
  Vector3d point, normal;  // m; from the obstacle, of length 1
};

// The path is straight, from `from` to `to`, in the frame of the obstacle, and begins outside or on the
// surface. Returns nothing if it does not enter, and nothing for planes, which a particle can't pass.
std::optional<Meeting> first_meeting(const Obstacle& obstacle, const Vector3d& from, const Vector3d& to);

}  // namespace hair
