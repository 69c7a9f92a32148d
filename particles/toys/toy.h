// Toys: point masses, springs between them, and constraints: rods and circular wires. Examples: a pendulum,
// beads on a wire, a patch of cloth, all made of the same particles and springs as hair.
#pragma once

#include <vector>

#include "particles/constraints.h"
#include "particles/gravity.h"
#include "particles/springs.h"
#include "particles/state.h"

namespace particles {

enum class ToyMethod { forward_euler, symplectic_euler, midpoint, runge_kutta_4, implicit_euler };

struct Toy {
  Particles particles;
  State start;
  std::vector<Spring> springs;
  Constraints constraints;  // if empty, P2 is not called. Not possible with implicit_euler
  ToyMethod method = ToyMethod::runge_kutta_4;
  Eigen::Vector3d gravity = Eigen::Vector3d(0, 0, -kEarthGravity);  // m/s^2
  double drag = 0;                                                  // kg/s, for each particle
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();                   // m/s

  // Only for a patch of cloth: the layout of its particles, for drawing. 0: no cloth.
  int rows = 0, columns = 0;
};

}  // namespace particles
