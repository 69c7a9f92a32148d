// The ellipsoids and capsules of a bust.
#pragma once

#include <span>

#include "hair/head/bust.h"

namespace hair {

enum class PartShape { ellipsoid, capsule };

struct BustPart {
  PartShape shape;
  bool paired;        // stands on both sides: its points are those of the side where x > 0
  bool carved;        // subtracted from the others, instead of joined
  double blend;       // m, the joint's k
  Vector3d a;         // m, an ellipsoid's centre, or a capsule's first end
  Vector3d b;         // m, the ellipsoid's radii, or the capsule's other end
  double radius = 0;  // m, of the capsule

  // Farther from `middle` than the reach, the part changes nothing near the surface.
  Vector3d middle = Vector3d::Zero();
  double reach_squared = 0;
};

// In the order in which they are joined. The first part is never left out.
std::span<const BustPart> bust_parts();

enum class LeaveOut { nothing, what_is_far };

// All parts, joined. Far parts may be left out, because they change nothing near the surface.
Bust::Value value_of_parts(const Vector3d& point, LeaveOut leave_out);

}  // namespace hair
