// STAFF ONLY.
#include "grader/exercise/H7/newton_euler.h"

namespace grader::h7 {
namespace {

struct Moving {
  Vector3d omega, alpha, a;
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();  // that it and what hangs from it need
};

Vector3d swing(const Moving& parent, const Vector3d& arm) {
  return parent.a + parent.alpha.cross(arm) + parent.omega.cross(parent.omega.cross(arm));
}

std::vector<Moving> motion_of(const Tree& tree, const VectorXd& accelerations) {
  const LinkPass& base = tree.passes[0];
  std::vector<Moving> all = {{base.v.angular, base.a.angular, base.a.linear}};
  for (std::size_t i = 1; i < tree.links.size(); ++i) {
    const Link& link = tree.links[i];
    const Moving& parent = all[link.parent];
    if (link.joint == JointType::prismatic) {
      const double rate = tree.rates[link.first], rises = accelerations[link.first];
      const Vector3d along = rises * link.u + 2 * rate * parent.omega.cross(link.u);
      all.push_back({parent.omega, parent.alpha, swing(parent, link.r) + along});
      continue;
    }
    Vector3d turn, turns_faster;
    if (link.joint == JointType::spherical) {
      turn = tree.rates.segment<3>(link.first);
      turns_faster = accelerations.segment<3>(link.first);
    } else {
      turn = tree.rates[link.first] * link.u;
      turns_faster = accelerations[link.first] * link.u + parent.omega.cross(turn);
    }
    Moving moving{parent.omega + turn, parent.alpha + turns_faster, swing(parent, link.r - link.d)};
    moving.a = swing(moving, link.d);
    all.push_back(moving);
  }
  return all;
}

}  // namespace

double unbalanced(const Tree& tree, const VectorXd& accelerations) {
  std::vector<Moving> all = motion_of(tree, accelerations);
  const double length = 1 + sizes_of(tree).length;
  double size = tree.Q.norm(), squared = 0;
  for (std::size_t i = tree.links.size() - 1; i > 0; --i) {
    const Link& link = tree.links[i];
    Moving& moving = all[i];
    const Vector3d force = link.inertia.M(0, 0) * moving.a;
    const Vector3d spin = link.tensor * moving.omega;
    const Vector3d torque = link.tensor * moving.alpha + moving.omega.cross(spin);
    size +=
        length * (force.norm() + link.external.force.norm()) + torque.norm() + link.external.torque.norm();
    moving.force += force - link.external.force;
    moving.torque += torque - link.external.torque;
    const Vector3d at_joint = moving.torque + link.d.cross(moving.force);
    const int k = link.first;
    if (link.joint == JointType::spherical) {
      const Vector3d held = link.stiffening * accelerations.segment<3>(k);
      squared += (at_joint + held - tree.Q.segment<3>(k)).squaredNorm();
      size += held.norm();
    } else {
      const double held = link.stiffening(0, 0) * accelerations[k];
      const double along =
          link.joint == JointType::revolute ? link.u.dot(at_joint) : link.u.dot(moving.force);
      squared += std::pow(along + held - tree.Q[k], 2);
      size += std::abs(held);
    }
    Moving& parent = all[link.parent];
    parent.force += moving.force;
    parent.torque += moving.torque + link.r.cross(moving.force);
  }
  return std::sqrt(squared) / size;
}

}  // namespace grader::h7
