// The interface of a force: an energy, the force itself, and products with its derivatives.
//
// Sign convention: where there is an energy E, the force is f = -dE/dx, so df/dx = -d2E/dx2, which is
// negative semi-definite where the energy is convex. All functions add to their output, so that forces sum
// up. x, v, dx, dv and all outputs have 3n entries.
#pragma once

#include "particles/vectors.h"

namespace solver {
class BlockBand;
}

namespace particles {

// Columns of 3n numbers that add_band uses.
inline constexpr int kBandScratch = 8;

class Force {
 public:
  virtual ~Force() = default;

  // J. 0 for a force without an energy, such as drag.
  virtual double energy(Input x) const = 0;

  // f += f(x, v), N.
  virtual void add_force(Input x, Input v, Output f) const = 0;

  // df += (df/dx) dx, dx in m and df in N. Some forces use an approximation of df/dx and document it.
  virtual void add_dfdx(Input x, Input v, Input dx, Output df) const = 0;

  // df += (df/dv) dv, dv in m/s and df in N.
  virtual void add_dfdv(Input x, Input v, Input dv, Output df) const = 0;

  // band += by_dfdx df/dx + by_dfdv df/dv, the lower half. The df/dx of the band is symmetric, negative
  // semi-definite and 0 between particles more than two apart: a local, definite part of the df/dx of
  // add_dfdx. It is used for preconditioners, so it changes how fast a system is solved, and not its
  // solution. Returns false, with any contents in the band, if a force has no such part, or if its products
  // turn out to be unsymmetric.
  virtual bool add_band(Input /*x*/, Input /*v*/, double /*by_dfdx*/, double /*by_dfdv*/,
                        solver::BlockBand& /*band*/, Scratch /*work*/) const {
    return false;
  }
};

}  // namespace particles
