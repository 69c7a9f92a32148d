// Bending of hair that is wavy or curly at rest. It takes the place of H2's angular springs for such a
// strand.
//
// An angle from 0 to pi can't hold a curl: a spring whose rest angle is not 0 has no direction at phi = 0,
// and lets a helix unwind freely, for the planes of its bends may turn about the strand at no cost. So a
// joint's bend is held as the vector phi b, of size phi along the axis b of the bend, by its two components
// in a frame that moves with the strand. At rest nothing is left to turn, as long as the frame at the root is
// held. Sources: M. Bergou et al., "Discrete Elastic Rods" (SIGGRAPH 2008), sections 4.2 and 6, for the
// frames and how they turn; the lecture, "Discretization".
//
// With u_{i-1} and u_i the directions of the segments that meet at joint i, u_{-1} = root_tangent, and phi_i
// the angle between them:
//
//   w_i = phi_i b_i,  b_i the direction of u_{i-1} x u_i
//   frame -1: root_tangent, root_normal, and their cross product
//   frame i: frame i-1, turned about b_i by phi_i ("parallel transport": it bends with the strand, and never
//            turns about it)
//   kappa_i = (w_i . second, w_i . third vector of frame i-1)
//   E = sum_i k_i |kappa_i - rest_i|^2 / 2,    k_0 = 2 EI / l_0,   k_i = EI / l, l = (l_{i-1} + l_i) / 2
//
// for i = 0 (the root's own joint, where half of the first segment bends) to the number of segments - 1. The
// unit of kappa is the radian. With rest = 0 the frames cancel, and what is left are H2's energies.
//
// A change of a segment turns all frames below it, by psi about the strand,
//
//   dpsi_i = dpsi_{i-1} - tan(phi_i / 2) b_i . (du_{i-1} + du_i),
//
// and so every joint has its say in the forces above it: two walks down the strand, O(n).
//
// The strand must be clamped. A segment of length 0 has no direction: it is skipped, and the joints at its
// two ends have no energy, force or product.
//
// At the fold, phi = pi, the axis is lost, and on the way there a frame turns by 2 / (pi - phi) times what the
// segments do. So joints that close forget: with y = (1 + cos(phi) - 0.01) / 0.09 between 0 and 1, a joint keeps the
// share c = y^2 (3 - 2y), and
//
//   s_i = c_0 c_1 ... c_i,   E = sum_i k_i (s_i |kappa_i - rest_i|^2 + (1 - s_i) (|kappa_i|^2 + |rest_i|^2)) / 2.
//
// Up to phi = 2.69 (154 degrees) in all joints, s = 1 and this is the sum above. From 3.00 (172 degrees) on, the
// joint and those below it are H2's angular springs, at a constant k |rest|^2 / 2 above those of straight hair, until
// it opens again. The energy is continuous with its first derivative, and forces are bounded by multiples of
// k / |e| (of all k in the sum for segments above), at the fold as anywhere; only H2's own jump of direction at
// phi = pi is left. At the fold itself a joint has the energy k (pi^2 + |rest|^2) / 2 and no force or product; the frame turns
// about its second vector.
//
// Forces and products still grow like 1 / |e| and 1 / |e|^2 as a segment vanishes, as H2's do. What comes of it
// in a simulation is in README.md.
#pragma once

#include "hair/mass_spring/strand_forces.h"

namespace hair {

using Eigen::Vector3d;

inline constexpr double kMostRest = 2.69;  // radians: up to here a joint keeps its frame

// The components kappa of a strand that lies at x, two for each segment; the rest_i of a strand that is at
// rest there. x: 3n, m. tangent and normal: of length 1, perpendicular to each other. Throws
// std::invalid_argument if x is not that of at least one particle, or if two neighbours are in the same
// place.
Eigen::VectorXd bend_components(Input x, const Vector3d& tangent, const Vector3d& normal);

class RestCurvature final : public particles::Force {
 public:
  // Refers to the strand. `rest` has two entries for each segment; `root_normal` is perpendicular to
  // root_tangent, to within 1e-6; no joint rests at more than kMostRest. Throws std::invalid_argument otherwise, and
  // for a strand that is not clamped.
  //
  // Products: exact, or definite, which is that of Gauss and Newton, -J^T k J with J = dr/dx of the r whose squares E adds
  // up (next to a fold without what turns kappa and has no energy there), and equal to the exact one at rest. The
  // force is -J^T k r with the same J, and so a step (M + h^2 J^T k J) dv = -h J^T k r gives the strand a kinetic
  // energy of at most E / 4, whatever h.
  RestCurvature(const Strand& strand, Eigen::VectorXd rest, const Vector3d& root_normal, Products product);

  // When the root turns, its normal does with root_tangent.
  void set_root_normal(const Vector3d& normal);

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input, Input, Input, Output) const override {}

 private:
  const Strand& strand_;
  Eigen::VectorXd rest_;
  Vector3d root_normal_;
  Products product_;
};

}  // namespace hair
