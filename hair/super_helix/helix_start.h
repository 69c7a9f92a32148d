// A strand's specification as a super-helix: its elements' natural curvatures and torsions, and its root.
//
// An element takes the mean curvature and torsion of its piece of the rest curve, so that a helix is exact
// with any number of elements, and a wave turns as it should in each of them. Of a groom's points, the bend
// at a point is spread over the two halves beside it, without twist.
#pragma once

#include "hair/strand/strand_spec.h"
#include "hair/super_helix/helix_motion.h"

namespace hair {

inline constexpr int kMostHelices = 400;   // elements: a step may take the memory of a dense matrix
inline constexpr double kMostTurns = 20;   // of an element
inline constexpr double kDrawnTurn = 0.3;  // rad: how far apart points of the centre line are on a curl
inline constexpr int kDrawnPoints = 16;    // of a strand, at least

struct HelixStart {
  HelixStrand strand;
  HelixRoot root;     // at rest
  Eigen::VectorXd q;  // 3n: the natural ones, or 0 for a strand that is held straight
  std::vector<double>
      places;  // m from the root: the points of the centre line, the root and the tip among them
};

// The reason why super-helices can't express a strand; empty if they can.
std::string why_not_of_helices(const StrandSpec& spec);

// How many points its centre line and its quadrature have, about.
long helix_points(const StrandSpec& spec);

// Throws std::invalid_argument for such a strand.
HelixStart helix_start(const StrandSpec& spec);

}  // namespace hair
