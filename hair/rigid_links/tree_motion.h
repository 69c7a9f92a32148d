// Moves a tree of links: calculates the links' positions from the joints' coordinates, for H7's passes.
#pragma once

#include "hair/rigid_links.h"
#include "hair/rigid_links/link_tree.h"
#include "hair/strand/turns.h"

namespace hair {

// The base, whose motion is given. Its velocity and acceleration are those of its own origin, along the
// axes of the world.
struct TreeBase {
  Vector3d position = Vector3d::Zero();  // m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  SpatialMotion velocity, acceleration;
};

// The position and orientation of a link.
struct LinkFrame {
  Vector3d position = Vector3d::Zero();  // m, of its centre of mass
  Vector3d joint = Vector3d::Zero();     // m, of its joint: the parent's point at which it is at rest
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond joint_axes = Eigen::Quaterniond::Identity();  // the orientation at q = 0
  Matrix3d axes = Matrix3d::Identity();                            // the orientation as a matrix
  Vector3d turn = Vector3d::Zero();                                // rad, of a spherical joint from q = 0
};

class TreeMotion {
 public:
  explicit TreeMotion(const LinkTree& tree);

  const LinkTree& tree() const { return tree_; }
  const std::vector<LinkFrame>& frames() const { return frames_; }

  // For forces: write those that depend on positions alone to links[i].external and links[i].stiffening
  // before the passes. Subtract those that depend on velocities from passes[i].bias between the first two
  // passes.
  std::vector<Link> links;
  std::vector<LinkPass> passes;

  // Sets frames() and the links' geometry and inertia. External forces and stiffening become 0. It is cheap
  // where the links are.
  void place(const TreeBase& base, Input q);

  // For the placed coordinates q: moves them for h seconds at constant rates, or calculates their derivative
  // by time.
  void turn(Input rates, double h, Output q) const;
  void derivative(Input q, Input rates, Output dq) const;

 private:
  void place_link(std::size_t i);

  LinkTree tree_;
  std::vector<LinkFrame> frames_;
  Eigen::VectorXd placed_;  // q
};

}  // namespace hair
