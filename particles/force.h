// A force as everything else sees it: an energy, the force itself, and products with its derivatives.
//
// Sign convention: where there is an energy E, the force is f = -dE/dx, and so df/dx = -d2E/dx2: a matrix
// that is negative semi-definite where the energy is convex. Everything is added to what the output holds, so
// that forces add up. x, v, dx, dv and all outputs have 3n entries.
#pragma once

#include "particles/vectors.h"

namespace particles {

class Force {
 public:
  virtual ~Force() = default;

  // J. Of a force that has none, such as drag, 0.
  virtual double energy(Input x) const = 0;

  // f += f(x, v), N.
  virtual void add_force(Input x, Input v, Output f) const = 0;

  // df += (df/dx) dx, dx in m and df in N; or an approximation of df/dx, where the force says so.
  virtual void add_dfdx(Input x, Input v, Input dx, Output df) const = 0;

  // df += (df/dv) dv, dv in m/s and df in N.
  virtual void add_dfdv(Input x, Input v, Input dv, Output df) const = 0;
};

}  // namespace particles
