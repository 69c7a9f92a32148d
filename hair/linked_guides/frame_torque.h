// The frames and the tangents of a guide's particles, for links and strips, and the torque on frames.
#pragma once

#include <span>
#include <vector>

#include "hair/static_links.h"
#include "particles/vectors.h"

namespace hair {

// frames[0] has the columns tangent, normal, tangent x normal. A particle's direction is that from the root
// to it, and the root's is the tangent. From particle to particle the least rotation takes one direction to
// the next, so frames do not twist (R. L. Bishop, "There is More than One Way to Frame a Curve", 1975). If a
// particle meets the root, its frame does not turn. tangent, normal: of length 1, perpendicular. x: 3n
// numbers, frames: n.
//
// Directions of single segments would turn with a hair's smallest wave, and move the end of a link's arm,
// which is many segments long.
void guide_frames(particles::Input x, const Eigen::Vector3d& tangent, const Eigen::Vector3d& normal,
                  std::span<Eigen::Matrix3d> frames);

// Each tangent is the direction from the previous to the next particle, of length 1; 0 if they coincide. 3n
// numbers.
void guide_tangents(particles::Input x, particles::Output tangents);

// The torque that links exert on the guides whose frames they use. H9 holds frames during a step: its force
// on particle a acts on a point, and its product ignores the frame's rotation. But when a particle at the
// distance r from its root moves by du, its frame turns by du/r. Without a torque on the frame, this feeds
// energy into the hair, and even stiff hair flutters.
//
// With arm = R offset, and c the direction from the root to a, the frame turns by c x (dx_a - dx_root) / r,
// and so
//
//   dd = dx_b - dx_a - e(dx),    e(dx) = (c x (dx_a - dx_root) / r) x arm
//
// in place of dx_b - dx_a. This part is the difference to H9's force: the whole is the force -k s (dd/dx)^T d
// with the product -k s (dd/dx)^T dd, which is symmetric and definite again. The root gets the opposite of
// the force on a, so linear momentum stays exact; the torques of both ends about the root cancel, except for
// the twist about c.
class FrameTorque {
 public:
  // roots[l]: the root of the guide of link l's particle a. Keeps references to both arguments.
  FrameTorque(const std::vector<StaticLink>& links, std::vector<int> roots);

  // Call this before each step: it holds the links' present strengths during the step.
  void hold(Input largest);

  void add_force(std::span<const Matrix3d> frames, Input x, Output f) const;
  void add_product(std::span<const Matrix3d> frames, Input x, Input dx, Output df) const;

 private:
  const std::vector<StaticLink>& links_;
  std::vector<int> roots_;
  Eigen::VectorXd stiffness_;  // k s, for each link
};

}  // namespace hair
