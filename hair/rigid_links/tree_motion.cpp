#include "hair/rigid_links/tree_motion.h"

#include <cmath>

namespace hair {

using Eigen::Quaterniond;

namespace {

Quaterniond quaternion(Input q, int first) {
  return Quaterniond(q.segment<4>(first));
}

}  // namespace

TreeMotion::TreeMotion(const LinkTree& tree)
    : links(tree.made_links()),
      passes(links.size()),
      tree_(tree),
      frames_(links.size()),
      placed_(Eigen::VectorXd::Constant(tree.coordinates(), std::nan(""))) {}

void TreeMotion::place(const TreeBase& base, Input q) {
  LinkFrame& root = frames_[0];
  const bool moves = q != placed_ || root.position != base.position ||
                     root.orientation.coeffs() != base.orientation.coeffs();
  if (moves) {
    placed_ = q;
    root.position = base.position;
    root.orientation = base.orientation;
    root.axes = base.orientation.toRotationMatrix();
  }
  passes[0] = {};
  passes[0].v = base.velocity;
  passes[0].a = base.acceleration;
  for (std::size_t i = 1; i < links.size(); ++i) {
    if (moves) place_link(i);
    Link& link = links[i];
    link.inertia.M = tree_.shapes()[i].mass * Matrix3d::Identity();
    link.inertia.H.setZero();
    link.inertia.J = link.tensor;
    link.external = {};
    link.stiffening.setZero();
  }
}

void TreeMotion::place_link(std::size_t i) {
  const LinkShape& shape = tree_.shapes()[i];
  const LinkFrame& parent = frames_[shape.parent];
  LinkFrame& frame = frames_[i];
  Link& link = links[i];
  const int first = tree_.coordinate(static_cast<int>(i));

  frame.joint_axes = parent.orientation * shape.rest;
  frame.orientation = frame.joint_axes;
  if (shape.joint == JointType::spherical) {
    frame.orientation = frame.joint_axes * quaternion(placed_, first);
    frame.turn = turn_of(quaternion(placed_, first));
  } else if (shape.joint == JointType::revolute) {
    frame.orientation = frame.joint_axes * Eigen::AngleAxisd(placed_[first], shape.axis);
  }
  frame.axes = frame.orientation.toRotationMatrix();

  const Vector3d to_joint = parent.axes * shape.joint_at;
  frame.joint = parent.position + to_joint;
  link.d = frame.axes * shape.center;
  link.r = to_joint + link.d;
  if (shape.joint != JointType::spherical) link.u = frame.axes * shape.axis;
  if (shape.joint == JointType::prismatic) {
    link.r += placed_[first] * link.u;
    link.d.setZero();
  }
  frame.position = parent.position + link.r;
  link.tensor = frame.axes * shape.moments.asDiagonal() * frame.axes.transpose();
}

void TreeMotion::turn(Input rates, double h, Output q) const {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const int first = tree_.coordinate(static_cast<int>(i));
    if (links[i].joint == JointType::spherical) {
      const Vector3d w = frames_[i].joint_axes.conjugate() * Vector3d(rates.segment<3>(links[i].first));
      q.segment<4>(first) = (turn_by(h * w) * quaternion(q, first)).normalized().coeffs();
    } else {
      q[first] += h * rates[links[i].first];
    }
  }
}

void TreeMotion::derivative(Input q, Input rates, Output dq) const {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const int first = tree_.coordinate(static_cast<int>(i));
    if (links[i].joint != JointType::spherical) {
      dq[first] = rates[links[i].first];
      continue;
    }
    Quaterniond half;
    half.w() = 0;
    half.vec() = frames_[i].joint_axes.conjugate() * Vector3d(rates.segment<3>(links[i].first) / 2);
    dq.segment<4>(first) = (half * quaternion(q, first)).coeffs();
  }
}

}  // namespace hair
