// STAFF ONLY. Makes trees of links for tests, and their forces by Newton's and Euler's laws.
#include "reference/H7/link_trees_for_tests.h"

#include <numbers>

namespace reference_tests {

using Eigen::Matrix3d;
using hair::LinkShape, hair::LinkTree, hair::TreeBase, hair::TreeMotion;

LinkTree random_tree(int links, const std::vector<JointType>& types, bool chain, RandomNumbers& numbers) {
  std::vector<LinkShape> shapes(links);
  for (int i = 0; i < links; ++i) {
    LinkShape& shape = shapes[i];
    shape.parent = chain ? i : numbers.below(i + 1);
    shape.joint = types[numbers.below(static_cast<int>(types.size()))];
    shape.axis = numbers.direction();
    shape.joint_at = numbers.vector(0.5);
    shape.center = numbers.vector(0.5);
    shape.rest = numbers.turn();
    shape.mass = numbers.between(0.5, 2);
    // A body's moments are those of mass at three distances from its planes.
    const Vector3d spread(numbers.between(0.01, 0.1), numbers.between(0.01, 0.1), numbers.between(0.01, 0.1));
    shape.moments = Vector3d::Constant(spread.sum()) - spread;
  }
  return LinkTree(shapes);
}

LinkTree rod_chain(int n, double length, double mass, double radius) {
  std::vector<LinkShape> shapes(n);
  for (int i = 0; i < n; ++i) {
    LinkShape& shape = shapes[i];
    shape.parent = i;
    shape.joint = JointType::spherical;
    if (i > 0) shape.joint_at = Vector3d(0, 0, -length / 2);
    shape.center = Vector3d(0, 0, -length / 2);
    shape.mass = mass;
    const double across = mass * (length * length / 12 + radius * radius / 4);
    shape.moments = Vector3d(across, across, mass * radius * radius / 2);
  }
  return LinkTree(shapes);
}

VectorXd random_coordinates(const LinkTree& tree, RandomNumbers& numbers) {
  VectorXd q(tree.coordinates());
  for (int i = 1; i < tree.links(); ++i) {
    const int first = tree.coordinate(i);
    if (tree.shapes()[i].joint == JointType::spherical)
      q.segment<4>(first) = numbers.turn().coeffs();
    else
      q[first] = tree.shapes()[i].joint == JointType::revolute
                     ? numbers.between(-std::numbers::pi, std::numbers::pi)
                     : numbers.between(-0.5, 0.5);
  }
  return q;
}

VectorXd joint_forces(const TreeMotion& motion, const TreeBase& base, const VectorXd& rates,
                      const VectorXd& accelerations) {
  struct Moving {
    Vector3d omega, alpha, a, force = Vector3d::Zero(), torque = Vector3d::Zero();
  };
  const LinkTree& tree = motion.tree();
  const auto& frames = motion.frames();
  std::vector<Moving> all(tree.links());
  all[0] = {base.velocity.angular, base.acceleration.angular, base.acceleration.linear};
  for (int i = 1; i < tree.links(); ++i) {
    const LinkShape& shape = tree.shapes()[i];
    const Moving& parent = all[shape.parent];
    Moving& link = all[i];
    const Vector3d u = frames[i].axes * shape.axis;
    const int k = tree.rate(i);
    link.omega = parent.omega;
    link.alpha = parent.alpha;
    Vector3d slides = Vector3d::Zero();
    if (shape.joint == JointType::spherical) {
      link.omega += rates.segment<3>(k);
      link.alpha += accelerations.segment<3>(k);
    } else if (shape.joint == JointType::revolute) {
      link.omega += rates[k] * u;
      link.alpha += accelerations[k] * u + parent.omega.cross(Vector3d(rates[k] * u));
    } else {
      slides = accelerations[k] * u + 2 * parent.omega.cross(Vector3d(rates[k] * u));
    }
    const Vector3d to_joint = frames[i].joint - frames[shape.parent].position;
    const Vector3d arm = frames[i].position - frames[i].joint;
    link.a = parent.a + parent.alpha.cross(to_joint) + parent.omega.cross(parent.omega.cross(to_joint)) +
             slides + link.alpha.cross(arm) + link.omega.cross(link.omega.cross(arm));
  }
  VectorXd Q(tree.rates());
  for (int i = tree.links() - 1; i > 0; --i) {
    const LinkShape& shape = tree.shapes()[i];
    Moving& link = all[i];
    const Matrix3d tensor = frames[i].axes * shape.moments.asDiagonal() * frames[i].axes.transpose();
    link.force += shape.mass * link.a - motion.links[i].external.force;
    link.torque += tensor * link.alpha + link.omega.cross(Vector3d(tensor * link.omega)) -
                   motion.links[i].external.torque;
    const Vector3d about_joint = link.torque + (frames[i].position - frames[i].joint).cross(link.force);
    const Vector3d u = frames[i].axes * shape.axis;
    const int k = tree.rate(i), size = hair::rates_of(shape.joint);
    if (shape.joint == JointType::spherical) Q.segment<3>(k) = about_joint;
    if (shape.joint == JointType::revolute) Q[k] = u.dot(about_joint);
    if (shape.joint == JointType::prismatic) Q[k] = u.dot(link.force);
    Q.segment(k, size) +=
        motion.links[i].stiffening.topLeftCorner(size, size) * accelerations.segment(k, size);
    Moving& parent = all[shape.parent];
    parent.force += link.force;
    parent.torque += about_joint + (frames[i].joint - frames[shape.parent].position).cross(link.force);
  }
  return Q;
}

void accelerate(TreeMotion& motion, const VectorXd& rates, const VectorXd& Q, VectorXd& accelerations) {
  outward_velocities(motion.links, rates, motion.passes);
  inward_inertias(motion.links, Q, motion.passes);
  outward_accelerations(motion.links, Q, motion.passes, accelerations);
}

void add_weight(const Vector3d& gravity, TreeMotion& motion) {
  for (int i = 1; i < motion.tree().links(); ++i)
    motion.links[i].external.force += motion.tree().shapes()[i].mass * gravity;
}

}  // namespace reference_tests
