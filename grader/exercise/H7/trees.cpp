// STAFF ONLY.
#include "grader/exercise/H7/trees.h"

#include <numbers>

#include "grader/suite/random_vector.h"
#include "hair/rigid_links.h"

namespace grader::h7 {
namespace {

using hair::LinkShape, hair::LinkTree, hair::TreeBase, hair::TreeMotion;

Vector3d any(Random& random, double size) {
  return random_vector(random, 3, size);
}

Eigen::Quaterniond any_turn(Random& random) {
  return Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
}

LinkShape any_shape(Random& random, JointType joint, int parent) {
  LinkShape shape;
  shape.parent = parent;
  shape.joint = joint;
  shape.axis = any(random, 1).normalized();
  shape.joint_at = any(random, 0.2);
  shape.center = any(random, 0.2);
  shape.rest = any_turn(random);
  shape.mass = random.uniform(0.5, 2);
  // The moments of a body are sums of its spread along the other two axes.
  const Vector3d spread(random.uniform(0.02, 0.1), random.uniform(0.02, 0.1), random.uniform(0.02, 0.1));
  shape.moments = Vector3d::Constant(spread.sum()) - spread;
  return shape;
}

VectorXd any_coordinates(Random& random, const LinkTree& tree) {
  VectorXd q = tree.rest();
  for (int i = 1; i < tree.links(); ++i) {
    const int at = tree.coordinate(i);
    if (tree.shapes()[i].joint == JointType::spherical)
      q.segment<4>(at) = any_turn(random).coeffs();
    else
      q[at] = tree.shapes()[i].joint == JointType::revolute
                  ? random.uniform(-std::numbers::pi, std::numbers::pi)
                  : random.uniform(-0.3, 0.3);
  }
  return q;
}

}  // namespace

Tree random_tree(Random& random, const TreeKind& kind) {
  std::vector<LinkShape> shapes;
  for (int i = 0; i < kind.links; ++i) {
    const JointType joint = kind.types[i < static_cast<int>(kind.types.size())
                                           ? i
                                           : random.integer(0, static_cast<int>(kind.types.size()) - 1)];
    shapes.push_back(any_shape(random, joint, kind.branches ? random.integer(0, i) : i));
    if (i % 3 == 1) {
      shapes.back().mass *= kind.lightest;
      shapes.back().moments *= kind.lightest;
    }
  }
  const LinkTree tree(shapes);
  TreeMotion motion(tree);
  TreeBase base;
  base.orientation = any_turn(random);
  base.acceleration = {any(random, 3), any(random, 3)};
  if (kind.moves) base.velocity = {any(random, 1), any(random, 1)};
  motion.place(base, any_coordinates(random, tree));
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    Link& link = motion.links[i];
    link.external = {any(random, 10), any(random, 10)};
    if (!kind.stiffens) continue;
    // Symmetric and positive, about as stiff as the joint is heavy.
    const hair::Matrix3d half = hair::Matrix3d::NullaryExpr([&] { return 0.5 * random.normal(); });
    if (link.joint == JointType::spherical)
      link.stiffening = half * half.transpose();
    else
      link.stiffening(0, 0) = half.squaredNorm();
  }
  Tree made{motion.links, motion.passes, VectorXd::Zero(tree.rates()),
            random_vector(random, tree.rates(), 5)};
  if (kind.moves) made.rates = random_vector(random, tree.rates(), kind.speed);
  return made;
}

VectorXd reference_passes(Tree& tree, int up_to) {
  VectorXd accelerations = VectorXd::Zero(tree.rates.size());
  hair::outward_velocities(tree.links, tree.rates, tree.passes);
  if (up_to > 1) hair::inward_inertias(tree.links, tree.Q, tree.passes);
  if (up_to > 2) hair::outward_accelerations(tree.links, tree.Q, tree.passes, accelerations);
  return accelerations;
}

Sizes sizes_of(const Tree& tree) {
  Tree moved = tree;
  reference_passes(moved, 1);
  Sizes sizes{0, 0, 0, 0};
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const Link& link = tree.links[i];
    sizes.length += link.r.norm() + link.d.norm();
    sizes.turn = std::max(sizes.turn, moved.passes[i].v.angular.norm());
    sizes.speed = std::max(sizes.speed, moved.passes[i].v.linear.norm());
    sizes.mass += link.inertia.M(0, 0);
  }
  // A joint's own rates, which the velocities of two links may hide.
  sizes.turn += tree.rates.norm();
  sizes.speed += tree.rates.norm() + sizes.turn * sizes.length;
  return sizes;
}

}  // namespace grader::h7
