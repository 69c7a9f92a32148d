// A solid that is given by its distance, in its own axes. Hair collides with it (obstacles.h), and it is
// drawn as triangles.
#pragma once

#include <Eigen/Geometry>

namespace hair {

using Eigen::Vector3d;

struct Surface {
  double distance;  // m, from a point to the surface; negative inside
  Vector3d normal;  // the way out, of length 1
};

class Solid {
 public:
  virtual ~Solid() = default;

  // The distance has the right sign everywhere, and is right to first order near the surface. Outside, it is
  // at most about twice the true one.
  virtual Surface surface_at(const Vector3d& point) const = 0;

  // Axis-aligned; all of it lies inside.
  virtual Eigen::AlignedBox3d box() const = 0;
};

}  // namespace hair
