// STAFF ONLY. Makes problems whose motions are known or quick to compute.
#pragma once

#include "hair/strand/make_strand.h"
#include "hair/truth/accurate_motion.h"

namespace reference_tests {

// 6 cm of hair in 6 segments, EA and EI `factor` times those of hair, horizontal at a hinge, for 0.1 s.
inline hair::Problem level_strand(double factor = 1e-3) {
  constexpr int kSegments = 6;
  constexpr double kLength = 0.06;
  hair::StrandStart start;
  start.strand = hair::uniform_strand({}, kSegments, kLength);
  start.strand.stretch_rigidity *= factor;
  start.state.x = Eigen::VectorXd::Zero(3 * (kSegments + 1));
  start.state.v = start.state.x;
  for (int i = 0; i <= kSegments; ++i) start.state.x[3 * i] = kLength * i / kSegments;
  hair::Scene scene;
  scene.name = "level";
  scene.hair.strands = {start};
  return hair::make_problem(scene, {.strand = 0, .duration = 0.1, .segments = {}});
}

// A strand whose root two motions move and turn one after the other, with keys within the 0.1 s.
inline hair::Problem carried_strand(double factor = 1e-3) {
  hair::Problem problem = level_strand(factor);
  problem.scene.hair.strands[0].strand.clamped = true;
  problem.scene.hair.strands[0].strand.root_tangent = hair::Vector3d::UnitX();
  problem.scene.hair.strands[0].root_normal = hair::Vector3d::UnitY();
  hair::Motion motion;
  motion.keys.push_back({0.013, {}});
  motion.keys.push_back(
      {0.047, {{0.01, 0.02, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(0.5, hair::Vector3d::UnitZ()))}});
  motion.keys.push_back(
      {0.081, {{0, 0.02, 0.01}, Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, hair::Vector3d::UnitY()))}});
  problem.scene.riders = {{motion, {0}, {}}};
  return problem;
}

// Without interruption and without a cache.
inline hair::AccurateMotion motion_of(const hair::Problem& problem, double tolerance = hair::kTightest) {
  const std::atomic<bool> interrupted = false;
  return hair::accurate_motion(problem, {tolerance, {}}, interrupted).value();
}

}  // namespace reference_tests
