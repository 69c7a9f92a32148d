// Rods and circular wires, as plain data. Their equations and the forces that maintain them are exercise P2
// (constraint_forces.h).
#pragma once

#include <vector>

#include "particles/vectors.h"

namespace particles {

struct Rod {
  int i, j;       // i != j
  double length;  // m, >= 0
};

// A circle that a particle slides along without friction.
struct Wire {
  int i;
  Vector3d centre, normal;  // m; the normal of the circle's plane, of length 1
  double radius;            // m, > 0
};

struct Constraints {
  std::vector<Rod> rods;
  std::vector<Wire> wires;
  double stiffness = 0;  // 1/s^2, >= 0
  double damping = 0;    // 1/s, >= 0; 2 sqrt(stiffness) is critical

  int rows() const { return static_cast<int>(rods.size() + 2 * wires.size()); }
};

}  // namespace particles
