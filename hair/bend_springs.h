// H3. The lecture's alternative to angular springs: additional linear springs, from each particle to the
// second next. Source: the lecture, "Alternative: More Linear Springs".
//
// With d the distance between particles i and i + 2, and d0 = l_i + l_{i+1} the sum of the rest lengths
// between them:
//
//   U = sum_i k_i (d - d0)^2 / 2      k_i = skip_rigidity / d0, N/m
//
// The rest shape is straight. "Difficulty: Each spring constant affects both bending and stretching": these
// springs resist stretching in addition to the segments' springs (twice, because they overlap), and do not
// resist small bends, because d - d0 is of second order in the angle. The assignment's text measures both
// effects.
//
// Two particles at the same place have neither force nor product, because the direction is undefined. A
// strand of fewer than 3 particles has no such springs. x, f, dx and df have 3n entries.
#pragma once

#include "hair/geometric_term.h"
#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;

// U, in J.
double bend_spring_energy(const Strand& strand, Input x);

// f += -dU/dx, N.
void add_bend_spring_force(const Strand& strand, Input x, Output f);

// df += (df/dx) dx, N; see hair/geometric_term.h.
void add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df);

}  // namespace hair
