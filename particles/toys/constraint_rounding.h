// Rounding in P2's equation. If no force acts on rods and wires, its right-hand side is not 0, but the
// rounding errors of its terms. These contradict each other if constraints are redundant, so no lambda solves
// the equation; and there is nothing to solve.
#pragma once

#include <algorithm>
#include <cmath>

#include "particles/constraints.h"
#include "particles/state.h"

namespace particles {

// The norm that the right-hand side of P2's equation may have by rounding alone:
//
//   64 u || for each row the sum of the sizes of its terms ||     u = 2^-53
//
// A term is a sum of up to six products of coordinates that are rounded themselves: 16 u of its size. The
// rest of 64 allows for a few steps. In the size of C a position counts with its distance from the origin,
// because its rounding error is proportional to that.
inline double constraint_rounding(const Constraints& constraints, const Particles& particles,
                                  const State& state, Input f) {
  const auto place = [&](int i) -> double { return state.x.segment<3>(3 * i).norm(); };
  const auto speed = [&](int i) -> double { return state.v.segment<3>(3 * i).norm(); };
  const auto pull = [&](int i) -> double {
    return particles.is_pinned(i) ? 0 : f.segment<3>(3 * i).norm() / particles.mass[i];
  };
  double squared = 0;
  // far: the distance of its ends from the origin; length: that of the row of J for one end.
  const auto add = [&](double length, double far, double at_rest, double speeds, double pulls) {
    const double size = speeds * speeds + length * (pulls + constraints.damping * speeds) +
                        constraints.stiffness * (length * far + at_rest);
    squared += size * size;
  };
  for (const Rod& rod : constraints.rods) {
    const double length = (state.x.segment<3>(3 * rod.i) - state.x.segment<3>(3 * rod.j)).norm();
    add(length, place(rod.i) + place(rod.j), rod.length * rod.length, speed(rod.i) + speed(rod.j),
        pull(rod.i) + pull(rod.j));
  }
  for (const Wire& wire : constraints.wires) {
    const double radius = (state.x.segment<3>(3 * wire.i) - wire.centre).norm();
    const double far = place(wire.i) + wire.centre.norm();
    add(radius, far, wire.radius * wire.radius, speed(wire.i), pull(wire.i));
    add(1, far, 0, speed(wire.i), pull(wire.i));
  }
  return std::ldexp(64, -53) * std::sqrt(squared);
}

}  // namespace particles
