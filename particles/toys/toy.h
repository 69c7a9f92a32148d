// Toys: points with mass, springs between them, rods and circular wires that hold them. A pendulum, beads on
// a wire, a patch of cloth: the same particles and springs as hair.
#pragma once

#include <vector>

#include "particles/constraints.h"
#include "particles/springs.h"
#include "particles/state.h"

namespace particles {

enum class ToyMethod { forward_euler, symplectic_euler, midpoint, runge_kutta_4, implicit_euler };

struct Toy {
  Particles particles;
  State start;
  std::vector<Spring> springs;
  Constraints constraints;  // none: P2 is not called. Not with implicit_euler
  ToyMethod method = ToyMethod::runge_kutta_4;
  Eigen::Vector3d gravity = Eigen::Vector3d(0, 0, -9.81);  // m/s^2
  double drag = 0;                                         // kg/s, of each particle
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();          // m/s

  // Of a patch of cloth: how its particles lie, to draw them as one. 0: there is none.
  int rows = 0, columns = 0;
};

}  // namespace particles
