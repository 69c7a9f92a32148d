// STAFF ONLY. Runs a scene with the exercises that are linked here: in a runner and in a worker the
// student's, in the suite the reference's.
#pragma once

#include <memory>
#include <vector>

#include "grader/judge/run/play.h"
#include "hair/dense/synthesis.h"
#include "hair/scene/scene.h"

namespace grader::inline judge {

// Runs until the scene ends or breaks. Frames stay in `played` if an exercise throws.
void play_scene(const hair::Scene& scene, Played& played);

// Makes the strands that a scene draws in the place of its guides (H10): all strands, seen or not.
class DenseStrands {
 public:
  // `strands` are the sizes of the scene's strands in points. Keeps a reference to the scene.
  DenseStrands(const hair::Scene& scene, const std::vector<int>& strands);

  // Returns the number of points of each strand, in all groups of dense hair.
  std::vector<int> sizes() const;

  // Returns their coordinates, m. `x` are the points of all guides, at `time`, s.
  Eigen::VectorXd at(const Eigen::VectorXd& x, double time);

 private:
  const hair::Scene& scene_;
  std::vector<Eigen::Index> first_;  // is the place in x of each group
  std::vector<std::unique_ptr<hair::Synthesis>> groups_;
};

}  // namespace grader::judge
