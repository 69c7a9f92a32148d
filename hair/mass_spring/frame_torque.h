// What links exert on the guides that their frames turn with. H9 holds frames during a step: its force on
// particle a is that on a point, and its product does not know that a frame turns. But a frame that turns by
// du/r when a particle at the distance r from its root moves by du, and takes no torque, feeds energy into
// the hair: it flutters, however stiff.
//
// With arm = R offset, and c the direction from the root to a, the frame turns by c x (dx_a - dx_root) / r,
// and so
//
//   dd = dx_b - dx_a - e(dx),    e(dx) = (c x (dx_a - dx_root) / r) x arm
//
// in place of dx_b - dx_a. Here is what this adds to the force -k s (dd/dx)^T d and to its product -k s
// (dd/dx)^T dd: together with H9's the product is symmetric and definite again. The root takes the opposite
// of what a gets, so that linear momentum stays exact; about the root the torques of both ends cancel, but
// for the twist about c.
#pragma once

#include <span>
#include <vector>

#include "hair/static_links.h"

namespace hair {

class FrameTorque {
 public:
  // roots[l]: the root of the guide of link l's particle a. Keeps references.
  FrameTorque(const std::vector<StaticLink>& links, std::vector<int> roots);

  // Before each step: what links can still exert. Their strengths stay as they are during the step.
  void hold(Input largest);

  void add_force(std::span<const Matrix3d> frames, Input x, Output f) const;
  void add_product(std::span<const Matrix3d> frames, Input x, Input dx, Output df) const;

 private:
  const std::vector<StaticLink>& links_;
  std::vector<int> roots_;
  Eigen::VectorXd stiffness_;  // k s, of each link
};

}  // namespace hair
