// A strand as a chain of rigid rods: one between each two points of its rest shape, with spherical joints.
//
// A rod's z axis points along it, outward. At rest, axes follow the strand without turning about it (parallel
// transport), so the rest shape alone gives the joints' turns at rest: these contain both its curvature and
// its torsion. A spring at a joint holds the rods in this position:
//
//   K = EI/l across, GJ/l along the mean tangent of the two rods,   l = (l1 + l2) / 2     inside the strand
//   K = 2 EI/l, 2 GJ/l                                             at a clamped root: half of a rod bends
//
// These are the constants of the continuum, as for H2: a finer division of a strand changes its shape to the
// second order in l. The root of a hinged strand has no spring.
//
// Damping is that of a fibre that also resists the rate of its bend and twist (Kelvin and Voigt's model): C =
// relaxation time * K. A joint's limit is a spring kLimitFactor times as stiff as the material's EI/l.
#pragma once

#include "hair/rigid_links/tree_system.h"
#include "hair/strand/strand_spec.h"

namespace hair {

inline constexpr double kLimitFactor = 1000;

struct LinkStrand {
  LinkTree tree;
  TreeForces forces;       // springs and rods; a caller adds weight and drag
  Eigen::VectorXd length;  // m, of each rod
  TreeBase base;           // the root: z along its tangent, x along its normal; at rest
  bool clamped;
  Eigen::VectorXd q, rates;
};

// The reason why rods can't express a strand; empty if they can.
std::string why_not_of_links(const StrandSpec& spec);

// Throws std::invalid_argument for such a strand, and as rest_shape does.
LinkStrand link_strand(const StrandSpec& spec);

}  // namespace hair
