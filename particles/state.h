// Particles: what they are, where they are and how fast they move.
#pragma once

#include <vector>

#include "particles/vectors.h"

namespace particles {

// What does not change from step to step.
struct Particles {
  Eigen::VectorXd mass;      // n, kg, > 0
  std::vector<char> pinned;  // n; not 0: moves with the velocity that it has, whatever pulls at it

  int count() const { return static_cast<int>(mass.size()); }
  bool is_pinned(int i) const { return pinned[i] != 0; }
};

struct State {
  Eigen::VectorXd x;  // positions, 3n, m
  Eigen::VectorXd v;  // velocities, 3n, m/s
};

}  // namespace particles
