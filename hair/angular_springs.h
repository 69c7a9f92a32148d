// H2. Bending: an angular spring at each joint, which gives hair its body. Sources: the lecture, "Add body:
// Angular Springs" and "Discretization".
//
// Joint i lies between the segments e1 = x_i - x_{i-1} and e2 = x_{i+1} - x_i, whose rest lengths are l1 and
// l2:
//
//   E = sum_i k_i phi_i^2 / 2     phi = atan2(|e1 x e2|, e1 . e2), from 0 (straight) to pi (folded)
//                                 k_i = EI / l, l = (l1 + l2) / 2, N m: k_i ~ 1/l_i
//
// A clamped strand has a joint at the root too: e1 is root_tangent, which does not move, and k = 2 EI / l2,
// for half of the first segment bends there.
//
// With u1, u2 the directions of e1, e2 and b = u1 x u2 / |u1 x u2| the axis of the bend (binormal),
//
//   dphi/de1 = -(b x u1) / |e1|,   dphi/de2 = (b x u2) / |e2|,
//   dphi/dx_{i-1} = -dphi/de1,  dphi/dx_i = dphi/de1 - dphi/de2,  dphi/dx_{i+1} = dphi/de2.
//
// Near phi = 0 the axis is lost, but phi b is not: it is u1 x u2 to third order, so that the force is smooth
// there. At the fold, phi = pi, the axis is lost and phi b with it. The force has the size k pi / |e| in any
// direction nearby, and at the fold itself, where all directions are alike, it is 0 by definition: a balance
// on a needle's point. A joint with a segment of length 0 has the angle 0, no energy, no force and no
// products.
//
// Nothing here is NaN or infinite as long as all lengths are 0 or between 1e-100 and 1e100 m. x, f, dx and df
// have 3n entries.
#pragma once

#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;

// E, in J.
double bend_energy(const Strand& strand, Input x);

// f += -dE/dx, N.
void add_bend_force(const Strand& strand, Input x, Output f);

// df += (df/dx) dx, N, exact. Indefinite at any bend: moving the two ends out of the bend's plane, one to
// either side, is an eigenvector of d2E, with the eigenvalue -k phi tan(phi/2) / |e|^2 where both segments
// have the length |e|. At the fold df += 0.
void add_bend_product(const Strand& strand, Input x, Input dx, Output df);

// df -= S dx with S positive semi-definite, for implicit steps: per joint
//
//   S = k (grad phi grad phi^T + max(phi cot phi, 0) g g^T),
//
// where g is the derivative of the bend out of the plane: g . dx = b . (de2 / |e2| - de1 / |e1|) with de the
// change of e. The first part is Gauss and Newton's. At phi = 0 S is exact, for any axis b perpendicular to
// the strand; and at a bend of rounding errors such an axis is needed, for what is left of u1 x u2 then
// points anywhere. At the fold df += 0.
void add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df);

}  // namespace hair
