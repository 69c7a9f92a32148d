// A tree of links that moves: from its joints' coordinates to where its links are, as H7's passes need them.
#pragma once

#include "hair/rigid_links.h"
#include "hair/rigid_links/link_tree.h"
#include "hair/strand/turns.h"

namespace hair {

// The base, which moves as it is told. Its velocity and acceleration are those of its own origin, along the
// axes of the world.
struct TreeBase {
  Vector3d position = Vector3d::Zero();  // m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  SpatialMotion velocity, acceleration;
};

// Where a link is.
struct LinkFrame {
  Vector3d position = Vector3d::Zero();  // m, of its centre of mass
  Vector3d joint = Vector3d::Zero();     // m, of its joint: the point of the parent where it is at rest
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond joint_axes = Eigen::Quaterniond::Identity();  // the orientation at q = 0
  Matrix3d axes = Matrix3d::Identity();                            // the orientation as a matrix
};

class TreeMotion {
 public:
  explicit TreeMotion(const LinkTree& tree);

  const LinkTree& tree() const { return tree_; }
  const std::vector<LinkFrame>& frames() const { return frames_; }

  // For forces: those that depend on places alone go to links[i].external and to links[i].stiffening before
  // the passes, and those that depend on velocities into passes[i].bias, with the other sign, between the
  // first two.
  std::vector<Link> links;
  std::vector<LinkPass> passes;

  // Sets frames() and the links' geometry and inertia. External forces and stiffening become 0.
  void place(const TreeBase& base, Input q);

  // Of the coordinates q as they were placed: moves them for h seconds at constant rates; their derivative by
  // time.
  void turn(Input rates, double h, Output q) const;
  void derivative(Input q, Input rates, Output dq) const;

 private:
  LinkTree tree_;
  std::vector<LinkFrame> frames_;
};

}  // namespace hair
