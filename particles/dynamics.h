// What explicit integrators see of a system: how it accelerates, and nothing of why.
#pragma once

#include "particles/vectors.h"

namespace particles {

class Dynamics {
 public:
  virtual ~Dynamics() = default;

  // a = x''(x, v), m/s^2, 3n entries each: overwrites all of a, leaves x and v alone. Pinned particles have
  // the acceleration 0.
  virtual void acceleration(Input x, Input v, Output a) = 0;
};

}  // namespace particles
