// X1. The drag of air on fast particles, which grows with the square of the speed. Source: the drag equation, F = rho u^2 C A / 2,
// of Lord Rayleigh, "On the resistance of fluids" (1876).
//
// With u the velocity of the air relative to a particle, the air pushes it along u by c |u| u. The coefficient c = rho C A / 2 of
// a particle has the unit kg/m: the density of the air, kg/m^3, times the area across the flow, m^2, times a number.
#pragma once

#include "particles/vectors.h"

namespace particles {

// f += c |w - v| (w - v) for each particle, N: v is its velocity and w that of the air around it, m/s. The coefficient c is the same
// for all and not negative. wind, v and f have 3n entries, n >= 0. Speeds are below 1e150 m/s, so that their squares are numbers.
void add_air_drag(double coefficient, Input wind, Input v, Output f);

}  // namespace particles
