// A strand's specification as a super-helix: its elements' natural curvatures and torsions, and its root.
//
// An element takes the mean curvature and torsion of its piece of the rest curve, so a helix is exact with
// any number of elements, and a wave turns by the right angle in each of them. For a groom's points, the bend
// at a point is spread over the two halves next to it, without twist.
#pragma once

#include "hair/strand/strand_spec.h"
#include "hair/super_helix/helix_motion.h"

namespace hair {

inline constexpr int kMostHelices = 400;   // elements: a step may take the memory of a dense matrix
inline constexpr double kMostTurns = 20;   // per element
inline constexpr double kDrawnTurn = 0.3;  // rad: between neighbouring points of the centre line on a curl
inline constexpr int kDrawnPoints = 16;    // per strand, at least

struct HelixStart {
  HelixStrand strand;
  HelixRoot root;     // at rest
  Eigen::VectorXd q;  // 3n: the natural ones, or 0 for a strand that is held straight
  std::vector<double>
      places;  // m from the root: the points of the centre line, the root and the tip among them
};

// The reason why super-helices can't express a strand; empty if they can.
std::string why_not_of_helices(const StrandSpec& spec);

// The approximate number of points of its centre line and its quadrature.
long helix_points(const StrandSpec& spec);

// Throws std::invalid_argument for such a strand.
HelixStart helix_start(const StrandSpec& spec);

}  // namespace hair
