// What a bust is made of.
#pragma once

#include <span>

#include "hair/head/bust.h"

namespace hair {

enum class PartShape { ellipsoid, capsule };

struct BustPart {
  PartShape shape;
  bool carved;        // taken away, instead of joined
  double blend;       // m, the joint's k
  Vector3d a;         // m, an ellipsoid's centre, or a capsule's first end
  Vector3d b;         // m, the ellipsoid's radii, or the capsule's other end
  double radius = 0;  // m, of the capsule

  // From the middle, beyond this distance, it changes nothing near the surface.
  Vector3d middle = Vector3d::Zero();
  double reach_squared = 0;
};

// In the order in which they are joined. The first is never left out.
std::span<const BustPart> bust_parts();

// Of the part alone: zero on its surface, and the distance near it.
Bust::Value value_of(const BustPart& part, const Vector3d& point);

enum class LeaveOut { nothing, what_is_far };

// Of all parts, joined. What is far may be left out: near the surface that changes nothing.
Bust::Value value_of_parts(const Vector3d& point, LeaveOut leave_out);

}  // namespace hair
