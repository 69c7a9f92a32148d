// A head on which hair grows: its surface, its scalp, and the directions in which its hair is combed. z is
// up, and the face looks along -y. Metres.
#pragma once

#include "hair/obstacles/solid.h"

namespace hair {

// A head is a solid: for any point but the centre it gives the distance from its surface, and the way out.
class Head : public Solid {
 public:
  // A point inside. A ray from it leaves the head once, at least where the scalp is.
  virtual Vector3d centre() const = 0;

  // The point where the ray in `direction` (of length 1) from the centre leaves the head.
  virtual Vector3d surface_towards(const Vector3d& direction) const = 0;

  // True if hair grows at this point of the surface.
  virtual bool has_hair(const Vector3d& point) const = 0;

  // The direction in which the hair of a point near the scalp is combed: a smooth field along the surface, of
  // length 1.
  virtual Vector3d combed(const Vector3d& point) const = 0;

  // 1 for a point near the face, 0 far from it, between them near its edge: hair is combed away from the
  // face, and does not fall over it.
  virtual double on_face(const Vector3d&) const { return 0; }
};

}  // namespace hair
