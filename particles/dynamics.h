// A system as explicit integrators see it: only its acceleration.
#pragma once

#include "particles/vectors.h"

namespace particles {

class Dynamics {
 public:
  virtual ~Dynamics() = default;

  // a = x''(x, v), m/s^2, 3n entries each. Overwrites all of a and does not change x and v. Pinned particles
  // have the acceleration 0.
  virtual void acceleration(Input x, Input v, Output a) = 0;
};

}  // namespace particles
