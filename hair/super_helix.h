// H8. Super-helices: a strand of n elements, in each of which the curvatures kappa1, kappa2 and the torsion
// tau are constant. These are its 3n coordinates q. The length is not a coordinate, so the strand never
// stretches. Sources: the lecture, "Super-Helices"; F. Bertails et al., "Super-Helices for Predicting the
// Dynamics of Natural Hair" (SIGGRAPH 2006); F. Bertails, "Linear Time Super-Helices" (Eurographics 2009).
//
//   M[s, q] q" + K (q - q^n) = A[t, q, q'] + integral of J^T F ds,     J = dr/dq,  r(s): the centre line
//
// M = rho S integral of J^T J ds, and K is diagonal. A is the force of the accelerations at q" = 0: it is
// given as a force at points, like weight and drag. So all integrals are sums over points, each with its own
// force and mass:
//
//   Q = sum of J_j^T force_j,     M = sum of J_j^T inertia_j J_j
//
// hair/helix.h explains the strand, its elements and its points. The functions change only their outputs.
#pragma once

#include <array>
#include <vector>

#include "hair/helix.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;
using particles::Scratch;

// (1) Stumpff's functions c_0 to c_7 of x >= 0,
//
//   c_k(x) = 1/k! - x/(k+2)! + x^2/(k+4)! - ..., x c_(k+2) = 1/k! - c_k, dc_k/dx = (k c_(k+2) - c_(k+1)) / 2
//
// c_0 = cos a and c_1 = sin(a) / a, where a = sqrt(x); c_2 and c_3 stand in the closed form of a helix, the
// others in its derivatives. For all x up to 1e6 the error of c_k is at most 1e-11 times the bound of c_k,
// 1/k! or, if that is smaller and k >= 2, 2 / ((k - 2)! x). So there is no jump. (x c_(k+2) = ... loses
// digits near x = 0; a series needs many terms if x is large.)
std::array<double, 8> stumpff(double x);

// (2) The centre line and frame at s in an element with this start: dr/ds = t, and n1, n2, t turn by Omega x,
// with Omega = kappa1 n1 + kappa2 n2 + tau t constant along the element. In the axes of the start, with p = s
// (kappa1, kappa2, tau) and e = (0, 0, 1),
//
//   axes = 1 + c_1 [p] + c_2 [p]^2,    position = s (e + c_2 p x e + c_3 p x (p x e)),    c_k of x = |p|^2
//
// Here [p] v = p x v. Errors, for |p| up to 200: 1e-10 in axes, and s times 1e-10 (a length) in position.
MaterialFrame frame_at(const MaterialFrame& start, const Vector3d& curvature, double s);

// Sets start and end of all elements from their lengths and curvatures: the first starts at the root, and
// each other element starts at the end of the previous one.
void carry_frames(const MaterialFrame& root, std::vector<HelixElement>& elements);

// (3) K: 3n numbers, N m^3. The strain energy is 1/2 (q - q^n)^T K (q - q^n) = the integral of
// 1/2 EI ((kappa1 - kappa1^n)^2 + (kappa2 - kappa2^n)^2) + 1/2 GJ (tau - tau^n)^2.
void helix_stiffness(const HelixStrand& strand, Output K);

// - K (q - q^n), N m^2.
void elastic_force(const HelixStrand& strand, Input q, Output force);

// (4) The Jacobian of point and frame at s with respect to the coordinates of their element, while its start
// is held. As integrals (n_k: n1, n2, t),
//
//   turns_k = integral from 0 to s of n_k(s') ds', moves_k = integral of n_k(s') x (r(s) - r(s')) ds'
//
// Errors: s times 1e-10 in turns, and s^2 times 1e-10 in moves.
HelixJacobian jacobian_at(const MaterialFrame& start, const Vector3d& curvature, double s);

// For (5) to (7) the caller has set start, end and at_end of all elements, and position and moves of all
// points. A point's J has the columns `moves` for its own element; those of an earlier element i are
//
//   turns_k x (position - end) + moves_k,    turns, moves: at_end of i,    end: its position
//
// Later elements don't move it.

// (5) Q = sum of J_j^T force_j, N m^2.
void generalised_force(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                       Output Q);

// (6) M = sum of J_j^T inertia_j J_j, 3n x 3n, kg m^4: all of it, symmetric to rounding.
void mass_matrix(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                 Eigen::Ref<Eigen::MatrixXd> M);

// (7) The semi-implicit step. The change of q' in h seconds, with elastic forces at the step's end, solves
//
//   (M + h^2 K) change = h (Q - K (q + h q' - q^n)),   M, Q: (6), (5) of these points;   afterwards q += h q'
//
// The matrix is definite for h > 0, even if M is singular. The residual is at most 1e-10 (norm of the matrix
// * norm of the change + norm of the right side). Scratch memory has 3n rows, 3n + 10 columns. A dense solve,
// which costs n^3, is good enough; but elements form a chain like H7's links, and elimination from the tip to
// the root costs n.
void helix_step(const HelixStrand& strand, const std::vector<HelixElement>& elements,
                const std::vector<HelixPoint>& points, Input q, Input rates, double h, Scratch scratch,
                Output change);

}  // namespace hair
