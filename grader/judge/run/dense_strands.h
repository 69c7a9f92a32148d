// STAFF ONLY. The strands that a scene draws in the place of its guides (H10): all of them, seen or not. In a
// player they are made with the student's functions, in the suite with the reference's.
#pragma once

#include <memory>
#include <vector>

#include "hair/head/synthesis.h"
#include "hair/scene/scene.h"

namespace grader::inline judge {

class DenseStrands {
 public:
  // strands: the points of each of the scene's strands. Keeps a reference to the scene.
  DenseStrands(const hair::Scene& scene, const std::vector<int>& strands);

  // The points of each strand, of all of the scene's groups of dense hair.
  std::vector<int> sizes() const;

  // Their coordinates, m. x: the points of all guides, at `time`, s.
  Eigen::VectorXd at(const Eigen::VectorXd& x, double time);

 private:
  const hair::Scene& scene_;
  std::vector<Eigen::Index> first_;  // number of x of each group
  std::vector<std::unique_ptr<hair::Synthesis>> groups_;
};

}  // namespace grader::judge
