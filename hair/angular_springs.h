// H2. Bending: an angular spring at each joint gives hair its body. Sources: the lecture, "Add body: Angular
// Springs" and "Discretization".
//
// Joint i lies between the segments e1 = x_i - x_{i-1} and e2 = x_{i+1} - x_i, whose rest lengths are l1 and
// l2:
//
//   U = sum_i k_i phi_i^2 / 2     phi = atan2(|e1 x e2|, e1 . e2), from 0 (straight) to pi (folded)
//                                 k_i = EI / l, l = (l1 + l2) / 2, N m: k_i ~ 1/l_i
//
// A clamped strand also has a joint at the root: e1 is root_tangent, which is fixed, and k = 2 EI / l2,
// because half of the first segment bends there.
//
// With u1, u2 the directions of e1, e2 and b = u1 x u2 / |u1 x u2| the axis of the bend (binormal),
//
//   dphi/de1 = -(b x u1) / |e1|,   dphi/de2 = (b x u2) / |e2|,
//   dphi/dx_{i-1} = -dphi/de1,  dphi/dx_i = dphi/de1 - dphi/de2,  dphi/dx_{i+1} = dphi/de2.
//
// At phi = 0 the axis b is undefined, but phi b is not: it is u1 x u2 up to third order, so the force is
// smooth there. At the fold, phi = pi, both b and phi b are undefined. Near the fold the force has the size k
// pi / |e|, in a direction that depends on the side; at the fold itself, where u1 x u2 is 0, it is 0 by
// definition (an unstable equilibrium). A joint with a segment of length 0 has the angle 0, no energy, no
// force and no products.
//
// All results are finite if every length is 0 or between 1e-100 and 1e100 m. x, f, dx and df have 3n entries.
#pragma once

#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;

// U, in J.
double bend_energy(const Strand& strand, Input x);

// f += -dU/dx, N.
void add_bend_force(const Strand& strand, Input x, Output f);

// df += (df/dx) dx, N, exact. Indefinite at any bend: moving the joint's two ends out of the bend's plane, to
// opposite sides, is an eigenvector of d2U, with the eigenvalue -k phi tan(phi/2) / |e|^2 if both segments
// have the length |e|. At the fold df += 0.
void add_bend_product(const Strand& strand, Input x, Input dx, Output df);

// df -= S dx with S positive semi-definite, for implicit steps: per joint
//
//   S = k (grad phi grad phi^T + max(phi cot phi, 0) g g^T),
//
// Here g is the derivative of the bend out of its plane: g . dx = b . (de2 / |e2| - de1 / |e1|), with de the
// change of e. The first part is the Gauss-Newton approximation. At phi = 0, S is exact for any axis b
// perpendicular to the strand. Such an axis is also needed if the bend is only rounding error, because u1 x
// u2 then has an arbitrary direction. At the fold df += 0.
void add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df);

}  // namespace hair
