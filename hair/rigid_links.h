// H7. Rigid links: Featherstone's articulated-body recursion finds the accelerations of all joints of a chain
// or tree in three passes over its links, in linear time. Sources: the lecture, "Featherstone Algorithm"; B.
// Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (PhD thesis, Berkeley 1996), chapter 4;
// the numbers of equations are his.
//
// The passes solve the equations of motion, without their matrix,
//
//   M(q) q" = Q - C(q, q')     Q: the joints' forces, N (prismatic) or N m; C: velocities, forces on links
//
// hair/link.h explains the link `links[i]`; hair/spatial.h explains spatial vectors, transforms and inertias.
// links[0] is the base; a pass begins with link 1 or ends with it. rates, Q and accelerations have one number
// for each revolute or prismatic joint and three for each spherical one; those of link i begin at
// links[i].first. passes[i] belongs to link i, and both lists have the same length.
//
// (1) Outward. A joint adds its motion to that of its parent, and a link on a curved path accelerates:
//
//   v^_i = iX(i-1) v^_(i-1) + s^_i q'_i
//   a^_i = iX(i-1) a^_(i-1) + s^_i q"_i + c^_i                                                         (4.23)
//   Z^_i = [0; omega x I omega] - the external force:  f^ = I^_i a^_i + Z^_i is Newton's and Euler's law
//
// c^_i is the rest of the derivative of v^_i after the first two terms. With omega the parent's angular
// velocity and w = u q' (spherical: the three rates) the joint's own:
//
//   prismatic:  c^ = [0; omega x (omega x r) + 2 omega x u q']
//   revolute:   c^ = [omega x w; omega x (omega x (r - d)) + (omega x w) x d + W x (W x d)],  W = omega + w
//   spherical:  as revolute, but with 0 in place of omega x w: the axes of its rates don't turn
//
// (2) Inward. The force that gives link i, with all links below it, the acceleration a^_i is f^ = I^A_i a^_i
// + Z^A_i (4.24). A link without children has I^A = I^ and Z^A = Z^; each child i adds the part that its
// joint passes on to its parent:
//
//   I^A_(i-1) += (i-1)Xi [ I^A - I^A s^ (s^'I^A s^)^-1 s^'I^A ] iX(i-1)                                (4.28)
//   Z^A_(i-1) += (i-1)Xi [ Z^A + I^A c^ + I^A s^ (s^'I^A s^)^-1 (Q - s^'(Z^A + I^A c^)) ]              (4.29)
//
// (3) Outward. From the base's acceleration, (4.23) with
//
//   q"_i = (s^'I^A s^)^-1 (Q - s^'I^A iX(i-1) a^_(i-1) - s^'(Z^A + I^A c^))                            (4.27)
//
// With a spherical joint s^ has three columns, and s^'I^A s^ is a matrix of 3 x 3. Wherever s^'I^A s^ stands
// in (4.27) to (4.29), the link's `stiffening` is added to it; link.h explains why.
//
// Slips in the lecture's transcript: the second term in the numerator of (4.27) holds the parent's
// acceleration a^_(i-1), not s^_(i-1); in the line above (4.27), Z^' is Z^A; the text before (4.27) and the
// display before (4.28) lose hats and primes. The prime is Mirtich's spatial transpose, see dot().
//
// Revolute and prismatic joints are required, spherical joints are extra. Good solutions allocate nothing,
// and their cost is linear in the number of links. Rounding may leave J and M of I^A unsymmetric by its own
// size.
#pragma once

#include <vector>

#include "hair/link.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;

// Pass 1: v, c and bias (Z^) of links 1 to n, from passes[0].v.
void outward_velocities(const std::vector<Link>& links, Input rates, std::vector<LinkPass>& passes);

// Pass 2: inertia (I^A) and bias (Z^A) of all links, and gain of links 1 to n. On entry bias is Z^, and
// passes[0].bias 0. On return passes[0] holds the base's I^A_0 and Z^A_0: the force I^A_0 a^_0 + Z^A_0 gives
// the base its acceleration a^_0.
void inward_inertias(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes);

// Pass 3: accelerations, and a of links 1 to n, from passes[0].a. Reads c, bias, inertia and gain as pass 2
// leaves them.
void outward_accelerations(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes,
                           Output accelerations);

}  // namespace hair
