// H1. Stretching: a linear spring along each segment. Source: the lecture, "Hair Model" and "Discretization".
//
// With l the length of segment i, l0 its rest length, and u the unit vector from particle i to particle i +
// 1:
//
//   U = sum_i k_i (l - l0)^2 / 2      k_i = EA / l0, N/m: k_i ~ 1/l_i
//   f on i = k_i (l - l0) u, and on i + 1 the opposite
//
// A segment of length 0 has no direction, so it has neither force nor product (its energy is still k l0^2 /
// 2). Any longer segment has both. A strand of 1 particle has no segments, and an energy of 0. x, f, dx and
// df have 3n entries.
#pragma once

#include "hair/geometric_term.h"
#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;

// U, in J.
double stretch_energy(const Strand& strand, Input x);

// f += -dU/dx, N.
void add_stretch_force(const Strand& strand, Input x, Output f);

// df += (df/dx) dx, N: symmetric, and exact with the full geometric term. With the filtered or dropped term,
// -df/dx is positive semi-definite.
void add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df);

}  // namespace hair
