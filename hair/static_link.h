// A static link between two particles of guide hairs, and the force law of the triangle strips between them.
// Particles are numbered through all strands: strand 0 first, then strand 1, ... Source: the lecture,
// "Control Mesh".
#pragma once

#include <Eigen/Core>

namespace hair {

using Eigen::Vector3d;

// A spring that holds particle b at its place in a's frame when the link was made.
struct StaticLink {
  int a = 0, b = 0;                    // a != b
  Vector3d offset = Vector3d::Zero();  // m: from a to b at rest, in a's frame
  double length = 0;                   // > 0, m: stretches are multiples of it
  double stiffness = 0;                // k >= 0, N/m
  double yields = 0, breaks = 0;       // stretches, 0 <= yields <= breaks
};

struct StripLaw {
  double thickness = 0;  // r > 0, m: the distance below which particles are pushed away
  double stiffness = 0;  // k >= 0, N/m
  double friction = 0;   // mu >= 0
};

}  // namespace hair
