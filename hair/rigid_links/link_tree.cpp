#include "hair/rigid_links/link_tree.h"

#include <Eigen/Eigenvalues>
#include <string>

#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_direction,
    particles::require_finite, particles::require_positive;

namespace {

// A moment of inertia below this part of the link's largest one is only rounding, and counts as 0.
constexpr double kNothing = 1e-13;

// The inertia tensor about the joint.
Matrix3d about_joint(const LinkShape& shape) {
  const Vector3d& d = shape.center;
  return Matrix3d(shape.moments.asDiagonal()) +
         shape.mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
}

void check_link(const LinkShape& shape, int number) {
  const std::string link = "link " + std::to_string(number), of = " of " + link;
  require(shape.parent >= 0 && shape.parent < number, "the parent" + of, shape.parent,
          "at least 0 and less than " + std::to_string(number));
  require_positive("the mass" + of, shape.mass);
  require_finite("the position of the joint" + of, shape.joint_at);
  require_finite("the centre of mass" + of, shape.center);
  for (const double moment : shape.moments) require_at_least("a moment of inertia" + of, moment, 0);
  const double norm = shape.rest.norm();
  require(std::abs(norm - 1) <= 1e-9, "the rest rotation's norm" + of, norm, "1");
  if (shape.joint != JointType::spherical) require_direction("the joint's axis" + of, shape.axis);
  if (shape.joint == JointType::prismatic) return;

  const Matrix3d inertia = about_joint(shape);
  const double least = shape.joint == JointType::revolute
                           ? shape.axis.dot(inertia * shape.axis)
                           : inertia.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
  require(least > kNothing * inertia.trace(), "the least moment of inertia about its joint" + of, least,
          "> 0: the joint would turn nothing");
}

}  // namespace

LinkTree::LinkTree(const std::vector<LinkShape>& shapes) : shapes_(1), places_(1, {0, 0}) {
  shapes_.insert(shapes_.end(), shapes.begin(), shapes.end());
  for (int i = 1; i < links(); ++i) {
    check_link(shapes_[i], i);
    places_.push_back({coordinates_, rates_});
    coordinates_ += shapes_[i].joint == JointType::spherical ? 4 : 1;
    rates_ += rates_of(shapes_[i].joint);
  }
}

Eigen::VectorXd LinkTree::rest() const {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(coordinates_);
  for (int i = 1; i < links(); ++i)
    if (shapes_[i].joint == JointType::spherical) q[coordinate(i) + 3] = 1;
  return q;
}

void LinkTree::normalise(Eigen::Ref<Eigen::VectorXd> q) const {
  for (int i = 1; i < links(); ++i)
    if (shapes_[i].joint == JointType::spherical) q.segment<4>(coordinate(i)).normalize();
}

std::vector<Link> LinkTree::made_links() const {
  std::vector<Link> links(shapes_.size());
  for (std::size_t i = 1; i < links.size(); ++i) {
    links[i].parent = shapes_[i].parent;
    links[i].joint = shapes_[i].joint;
    links[i].first = places_[i].rate;
    links[i].inertia.M = shapes_[i].mass * Matrix3d::Identity();
  }
  return links;
}

}  // namespace hair
