// The sphere that fits roots best: what is known of a head that only its hair tells of.
#pragma once

#include <optional>
#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

struct RootSphere {
  Vector3d centre;
  double radius;
};

// The least squares of |x|^2 - 2 c . x - (r^2 - |c|^2), which is linear in its unknowns: I. Kasa, "A circle
// fitting procedure and its error analysis" (IEEE Transactions on Instrumentation and Measurement 25, 1976).
// None for fewer than four points, and for points that are on a plane but for a hundredth of their width.
std::optional<RootSphere> sphere_through(const std::vector<Vector3d>& points);

// The roots with the scalp's normals for axes. axis of what is given: how hair leaves its root. The normals
// are those of the sphere that fits; of roots on a plane the plane's, on the side that hair is on; of roots
// on a line they stay what they are.
std::vector<RootFrame> scalp_of_roots(std::vector<RootFrame> roots);

}  // namespace hair
