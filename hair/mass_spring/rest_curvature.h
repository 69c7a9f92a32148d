// Bending of hair that is wavy or curly at rest. It replaces H2's angular springs for such a strand.
//
// An angle from 0 to pi can't represent a curl: a spring with a rest angle other than 0 has no direction at
// phi = 0, and lets a helix unwind freely, because the planes of its bends can turn about the strand without
// energy. So a joint's bend is the vector phi b, of size phi along the axis b of the bend, with two
// components in a frame that moves with the strand. If the frame at the root is fixed, the rest shape then
// has no free rotation. Sources: M. Bergou et al., "Discrete Elastic Rods" (SIGGRAPH 2008), sections 4.2 and
// 6, for the frames and their rotation; the lecture, "Discretization".
//
// Let u_{i-1} and u_i be the directions of the two segments at joint i, u_{-1} = root_tangent, and phi_i the
// angle between them:
//
//   w_i = phi_i b_i,  b_i the direction of u_{i-1} x u_i
//   frame -1: root_tangent, root_normal, and their cross product
//   frame i: frame i-1, turned about b_i by phi_i ("parallel transport": it bends with the strand, and never
//            turns about it)
//   kappa_i = (w_i . second, w_i . third vector of frame i-1)
//   E = sum_i k_i |kappa_i - rest_i|^2 / 2,    k_0 = 2 EI / l_0,   k_i = EI / l, l = (l_{i-1} + l_i) / 2
//
// for i = 0 (the root's own joint, where half of the first segment bends) to the number of segments - 1. The
// unit of kappa is the radian. With rest = 0 the frames cancel, and E is H2's energy.
//
// A change of a segment rotates all frames below it, by psi about the strand,
//
//   dpsi_i = dpsi_{i-1} - tan(phi_i / 2) b_i . (du_{i-1} + du_i),
//
// so every joint contributes to the forces above it: two walks down the strand, O(n).
//
// The strand must be clamped. A segment of length 0 has no direction: it is skipped, and the joints at its
// two ends have no energy, force or product.
//
// At the fold, phi = pi, the axis is undefined, and near it a frame turns by 2 / (pi - phi) times the
// segments' rotation. So joints lose the frame as they close: with y = (1 + cos(phi) - 0.01) / 0.09, clamped
// to 0..1, a joint keeps the part c = y^2 (3 - 2y), and
//
//   s_i = c_0 ... c_i, E = sum_i k_i (s_i |kappa_i - rest_i|^2 + (1 - s_i) (|kappa_i|^2 + |rest_i|^2)) / 2.
//
// If all joints have phi <= 2.69 (154 degrees), s = 1 and this is the sum above. At phi >= 3.00 (172
// degrees), the joint and those below it act as H2's angular springs, with an energy larger by the constant k
// |rest|^2 / 2 than for straight hair, until the joint opens again. The energy and its first derivative are
// continuous. Forces are bounded by multiples of k / |e| (with the sum of all k for segments above), also at
// the fold; only H2's own jump of direction at phi = pi remains. At the fold itself a joint has the energy k
// (pi^2 + |rest|^2) / 2 and no force or product; the frame turns about its second vector.
//
// Forces and products grow like 1 / |e| and 1 / |e|^2 as a segment shrinks to 0, as H2's do. hair/README.md
// describes the consequences in a simulation.
#pragma once

#include "hair/mass_spring/strand_forces.h"

namespace hair {

using Eigen::Vector3d;

inline constexpr double kMostRest = 2.69;  // radians: up to this angle a joint keeps its whole frame

// The components kappa of a strand at x, two for each segment: the rest_i of a strand whose rest shape is x.
// x: 3n, m. tangent and normal: of length 1, perpendicular to each other. Throws std::invalid_argument if x
// does not hold at least one particle, or if two neighbours are at the same place.
Eigen::VectorXd bend_components(Input x, const Vector3d& tangent, const Vector3d& normal);

class RestCurvature final : public particles::Force {
 public:
  // Keeps a reference to the strand. `rest` has two entries for each segment; `root_normal` is perpendicular
  // to root_tangent within 1e-6; no joint has a rest angle above kMostRest; the strand is clamped. Otherwise
  // throws std::invalid_argument.
  //
  // Products: exact or definite. The definite product is the Gauss-Newton one, -J^T k J with J = dr/dx, where
  // E is the sum of the squares of r (near a fold without the rotation of kappa that has no energy there); it
  // equals the exact one at rest. The force is -J^T k r with the same J, so a step (M + h^2 J^T k J) dv = -h
  // J^T k r gives the strand a kinetic energy of at most E / 4, for any h.
  RestCurvature(const Strand& strand, Eigen::VectorXd rest, const Vector3d& root_normal, Products product);

  // Sets the new normal of a root that has turned; it belongs to the new root_tangent.
  void set_root_normal(const Vector3d& normal);

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input, Input, Input, Output) const override {}
  // The band leaves out the frames' turn, by which every joint acts on all particles above it.
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override;

 private:
  const Strand& strand_;
  Eigen::VectorXd rest_;
  Vector3d root_normal_;
  Products product_;
};

}  // namespace hair
