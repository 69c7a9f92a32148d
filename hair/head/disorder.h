// What makes dense hair look grown: strands that gather to locks, and a few that fly away.
//
// By chance some children are the middles of clumps, one of `clump`. Each child's tip goes a part,
// `gathered`, of the way to that of the nearest middle, and its points less, the nearer they are to the root.
// A fly-away is in no clump; it goes aside as the square of how far a point is along the strand.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "hair/head/synthesis.h"

namespace hair {

class Disorder {
 public:
  // Of the description's children; the same seed gives the same. Empty, and free, without clumps and
  // fly-aways.
  explicit Disorder(const SynthesisDescription& description);

  // Moves a child's points, 3 x points, but its first. `turn`: of the scalp since the start. `turns`: of the
  // guide of its wisp, a point each, or empty.
  void apply(int child, const RootFrame& root, const ScalpTurn& turn, std::span<const Eigen::Matrix3d> turns,
             Eigen::Ref<Eigen::VectorXd> points) const;

  // How far it moves a point at most, of a strand whose points are at most `far` from its root.
  double reach(int child, double far) const;

 private:
  void choose_clumps(const SynthesisDescription& description);
  void choose_fly_aways(const SynthesisDescription& description);

  std::vector<Eigen::Vector3d> gathers_;  // at the start, to where a tip goes; empty: no clumps
  std::vector<Eigen::Vector3d> sways_;    // as a root sees it, over the strand's reach; empty: no fly-aways
};

}  // namespace hair
