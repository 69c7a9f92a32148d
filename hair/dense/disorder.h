// Makes dense hair look grown: strands gather into locks, and a few fly away.
//
// Some children, chosen at random, are the middles of clumps: one of `clump`. Each child's tip moves by the
// part `gathered` towards the tip of the nearest middle; its other points move less, the nearer they are to
// the root. A fly-away is in no clump; its points move aside by the square of their place along the strand.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "hair/dense/synthesis.h"

namespace hair {

class Disorder {
 public:
  // For the description's children; the same seed gives the same result. Without clumps and fly-aways it is
  // empty and costs nothing.
  explicit Disorder(const SynthesisDescription& description);

  // Moves a child's points, 3 x points, but not the first. `turn`: the rotation of the scalp since the start.
  // `turns`: the frames of its wisp's guide, one for each point, or empty.
  void apply(int child, const RootFrame& root, const ScalpTurn& turn, std::span<const Eigen::Matrix3d> turns,
             Eigen::Ref<Eigen::VectorXd> points) const;

  // The largest distance by which it moves a point, for a strand whose points are at most `far` from its
  // root.
  double reach(int child, double far) const;

 private:
  void choose_clumps(const SynthesisDescription& description);
  void choose_fly_aways(const SynthesisDescription& description);

  std::vector<Eigen::Vector3d> gathers_;  // the target's offset from a tip, at the start; empty: no clumps
  std::vector<Eigen::Vector3d> sways_;    // in the root's frame, for a strand of reach 1; empty: no fly-aways
};

}  // namespace hair
