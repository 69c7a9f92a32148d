// STAFF ONLY.
#include "reference/tests/link_trees.h"

#include <numbers>

namespace reference_tests {

using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::Quaterniond;
using hair::Link, hair::LinkShape, hair::LinkTree, hair::TreeBase, hair::TreeMotion;

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

TreeBase random_base(RandomNumbers& numbers) {
  return {numbers.vector(3),
          numbers.turn(),
          {numbers.vector(3), numbers.vector(3)},
          {numbers.vector(9), numbers.vector(9)}};
}

namespace {

// Where a link is, and how it moves, seen from a point that does not.
struct Place {
  Isometry3d at;               // its axes, at its centre of mass
  Vector3d joint;              // the point of its parent
  Vector3d joint_moves;        // and this point's velocity
  std::vector<Vector3d> axes;  // one for each rate
  Vector3d omega, v;
};

std::vector<Place> places(const LinkTree& tree, const TreeBase& base, const VectorXd& q,
                          const VectorXd& rates) {
  std::vector<Place> links(tree.links());
  links[0].at = Eigen::Translation3d(base.position) * base.orientation;
  links[0].omega = base.velocity.angular;
  links[0].v = base.velocity.linear;
  for (int i = 1; i < tree.links(); ++i) {
    const LinkShape& shape = tree.shapes()[i];
    const Place& parent = links[shape.parent];
    Place& place = links[i];
    Isometry3d joint = parent.at * Eigen::Translation3d(shape.joint_at) * shape.rest;
    place.joint = joint.translation();
    place.joint_moves = parent.v + parent.omega.cross(Vector3d(place.joint - parent.at.translation()));
    const Vector3d u = joint.linear() * shape.axis;
    const double* at = q.data() + tree.coordinate(i);
    if (shape.joint == JointType::revolute) joint = joint * Eigen::AngleAxisd(*at, shape.axis);
    if (shape.joint == JointType::prismatic) joint = joint * Eigen::Translation3d(*at * shape.axis);
    if (shape.joint == JointType::spherical) joint = joint * Quaterniond(at);
    place.at = joint * Eigen::Translation3d(shape.center);
    place.axes = {u};
    if (shape.joint == JointType::spherical)
      place.axes = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
    Vector3d w = Vector3d::Zero(), slide = Vector3d::Zero();
    for (std::size_t k = 0; k < place.axes.size(); ++k)
      (shape.joint == JointType::prismatic ? slide : w) += rates[tree.rate(i) + k] * place.axes[k];
    place.omega = parent.omega + w;
    const Vector3d arm = place.at.translation() - place.joint;
    place.v = place.joint_moves + slide + place.omega.cross(arm);
  }
  return links;
}

}  // namespace

DenseMotion dense_motion(const TreeMotion& motion, const TreeBase& base, const VectorXd& q,
                         const VectorXd& rates) {
  const LinkTree& tree = motion.tree();
  const std::vector<Place> all = places(tree, base, q, rates);
  const int n = tree.rates();
  DenseMotion dense{MatrixXd::Zero(n, n), VectorXd::Zero(n)};
  for (int i = 1; i < tree.links(); ++i) {
    const Place& place = all[i];
    const Vector3d x = place.at.translation();
    MatrixXd turns = MatrixXd::Zero(3, n), moves = MatrixXd::Zero(3, n);
    Vector3d alpha = base.acceleration.angular;
    Vector3d a = base.acceleration.linear + alpha.cross(Vector3d(x - base.position)) +
                 base.velocity.angular.cross(Vector3d(place.v - base.velocity.linear));
    for (int j = i; j > 0; j = tree.shapes()[j].parent) {
      const JointType type = tree.shapes()[j].joint;
      const Vector3d& carrier = all[tree.shapes()[j].parent].omega;
      for (std::size_t k = 0; k < all[j].axes.size(); ++k) {
        const int column = tree.rate(j) + static_cast<int>(k);
        const double rate = rates[column];
        const Vector3d& u = all[j].axes[k];
        const Vector3d turned = type == JointType::spherical ? Vector3d::Zero() : carrier.cross(u);
        if (type == JointType::prismatic) {
          moves.col(column) = u;
          a += rate * turned;
          continue;
        }
        turns.col(column) = u;
        moves.col(column) = u.cross(Vector3d(x - all[j].joint));
        alpha += rate * turned;
        a += rate *
             (turned.cross(Vector3d(x - all[j].joint)) + u.cross(Vector3d(place.v - all[j].joint_moves)));
      }
    }
    const double mass = tree.shapes()[i].mass;
    const Matrix3d axes = place.at.linear();
    const Matrix3d tensor = axes * tree.shapes()[i].moments.asDiagonal() * axes.transpose();
    const hair::SpatialForce& external = motion.links[i].external;
    dense.M += mass * moves.transpose() * moves + turns.transpose() * tensor * turns;
    dense.C +=
        moves.transpose() * (mass * a - external.force) +
        turns.transpose() * (tensor * alpha + place.omega.cross(tensor * place.omega) - external.torque);
  }
  for (int i = 1; i < tree.links(); ++i) {
    const int size = hair::rates_of(tree.shapes()[i].joint);
    dense.M.block(tree.rate(i), tree.rate(i), size, size) +=
        motion.links[i].stiffening.topLeftCorner(size, size);
  }
  return dense;
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
