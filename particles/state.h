// Particles: masses, positions and velocities.
#pragma once

#include <vector>

#include "particles/vectors.h"

namespace particles {

// The constants of a simulation.
struct Particles {
  Eigen::VectorXd mass;      // n, kg, > 0
  std::vector<char> pinned;  // n; a particle whose entry is not 0 keeps its velocity under any force

  int count() const { return static_cast<int>(mass.size()); }
  bool is_pinned(int i) const { return pinned[i] != 0; }
};

struct State {
  Eigen::VectorXd x;  // positions, 3n, m
  Eigen::VectorXd v;  // velocities, 3n, m/s
};

}  // namespace particles
