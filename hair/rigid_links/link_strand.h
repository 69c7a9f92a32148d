// A strand as a chain of rigid rods: one between each two points of its rest shape, with spherical joints.
//
// A rod's axes: z along it, outward. At rest, axes go down the strand without turning about it (parallel
// transport), so the rest shape alone says how joints are turned at rest; its curvature and torsion are both
// in that. A spring at a joint holds the rods to this:
//
//   K = EI/l across, GJ/l along the mean tangent of the two rods,   l = (l1 + l2) / 2        inside of the strand
//   K = 2 EI/l, 2 GJ/l                                                at a clamped root: half of the first rod bends
//
// These are the constants of the continuum, as those of H2: dividing a strand more finely changes its shape
// to the second order in l. The root of a hinged strand has no spring.
//
// Damping is that of a fibre that resists the rate of its bend and twist, too (Kelvin and Voigt's model): C =
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
