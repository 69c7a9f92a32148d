// The sphere that fits roots best: an estimate of the head if only its hair is known.
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
// None for fewer than four points, or for points that lie on a plane up to a hundredth of their width.
std::optional<RootSphere> sphere_through(const std::vector<Vector3d>& points);

// The roots, with the scalp's normals as axes. On entry `axis` is the direction in which hair leaves its
// root. The normals are those of the fitted sphere. For roots on a plane they are the plane's, on the side of
// the hair; for roots on a line they do not change.
std::vector<RootFrame> scalp_of_roots(std::vector<RootFrame> roots);

}  // namespace hair
