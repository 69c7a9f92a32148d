// STAFF ONLY. Draws trees for H7's cases.
#include "reference/H7/answers.h"

#include <algorithm>
#include <numbers>

#include "grader/judge/cases/random.h"
#include "hair/rigid_links.h"

namespace grader::h7 {
namespace {

using hair::LinkShape, hair::LinkTree, hair::TreeBase, hair::TreeMotion;

Vector3d any(Random& random, double size) {
  return random_vector(random, 3, size);
}

Eigen::Quaterniond any_turn(Random& random) {
  return Eigen::Quaterniond(Eigen::Vector4d(random_vector(random, 4))).normalized();
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
  Vector3d spread;
  for (double& one : spread) one = random.uniform(0.02, 0.1);
  shape.moments = Vector3d::Constant(spread.sum()) - spread;
  return shape;
}

// Link `number` hangs from this one.
int parent_of(Random& random, const TreeKind& kind, int number) {
  constexpr int kStrands = 3;
  switch (kind.form) {
    case Form::chain:
      return number - 1;
    case Form::branches:
      return number == 1 ? 0 : random.integer(0, number == kind.links ? number - 2 : number - 1);
    case Form::strands:
      return number == 1 ? 0 : std::max(1, number - kStrands);
    case Form::star:
      return 0;
  }
  return 0;
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
    shapes.push_back(any_shape(random, joint, parent_of(random, kind, i + 1)));
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
    if (kind.form == Form::star) link.r.setZero();
    if (!kind.stiffens) continue;
    // The stiffening is symmetric and positive, and about as large as the joint's inertia.
    const hair::Matrix3d half = hair::Matrix3d::NullaryExpr([&] { return 0.5 * random.normal(); });
    if (link.joint == JointType::spherical)
      link.stiffening = half * half.transpose();
    else
      link.stiffening(0, 0) = half.squaredNorm();
  }
  Tree made{motion.links, motion.passes, VectorXd::Zero(tree.rates()),
            random_vector(random, tree.rates(), 5)};
  if (kind.moves) made.rates = random_vector(random, tree.rates(), 2);
  return made;
}

Tree part_of(const Tree& tree, const std::vector<int>& chosen) {
  Tree part;
  part.passes = part_of(tree.passes, chosen);
  int rates = 0;
  for (const int i : chosen) {
    Link link = tree.links[i];
    const bool base = part.links.empty();
    link.parent = base ? 0 : static_cast<int>(std::ranges::find(chosen, link.parent) - chosen.begin());
    link.first = rates;
    if (!base) rates += hair::rates_of(link.joint);
    part.links.push_back(link);
  }
  part.rates = part_of(tree, tree.rates, chosen);
  part.Q = part_of(tree, tree.Q, chosen);
  return part;
}

std::vector<LinkPass> part_of(const std::vector<LinkPass>& passes, const std::vector<int>& chosen) {
  std::vector<LinkPass> part;
  for (const int i : chosen) part.push_back(passes[i]);
  return part;
}

VectorXd part_of(const Tree& tree, const VectorXd& numbers, const std::vector<int>& chosen) {
  std::vector<double> part;
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    const Link& link = tree.links[chosen[i]];
    for (int k = 0; k < hair::rates_of(link.joint); ++k) part.push_back(numbers[link.first + k]);
  }
  return VectorXd::Map(part.data(), static_cast<Eigen::Index>(part.size()));
}

Tree in_units(const Tree& tree, const Units& units) {
  const double mass = units.mass, length = units.length, time = units.time;
  const double rate = 1 / time, twice = rate * rate, moment = mass * length * length;
  const auto inertia = [&](hair::SpatialInertia& I) { I.M *= mass, I.H *= mass * length, I.J *= moment; };
  const auto force = [&](hair::SpatialForce& f) {
    f.force *= mass * length * twice, f.torque *= moment * twice;
  };
  Tree scaled = tree;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    Link& link = scaled.links[i];
    const bool slides = link.joint == JointType::prismatic;
    link.d *= length, link.r *= length, link.tensor *= moment;
    link.stiffening *= slides ? mass : moment;
    force(link.external);
    inertia(link.inertia);
    LinkPass& pass = scaled.passes[i];
    pass.v.angular *= rate, pass.v.linear *= length * rate;
    for (hair::SpatialMotion* motion : {&pass.c, &pass.a})
      motion->angular *= twice, motion->linear *= length * twice;
    force(pass.bias);
    inertia(pass.inertia);
    pass.gain /= slides ? mass : moment;
    if (i == 0) continue;
    const int count = hair::rates_of(link.joint);
    scaled.rates.segment(link.first, count) *= slides ? length * rate : rate;
    scaled.Q.segment(link.first, count) *= (slides ? mass * length : moment) * twice;
  }
  return scaled;
}

hair::SpatialMotion axis_of(const Link& link) {
  if (link.joint == JointType::prismatic) return {Vector3d::Zero(), link.u};
  return {link.u, link.u.cross(link.d)};
}

VectorXd reference_passes(Tree& tree, int up_to) {
  VectorXd accelerations = VectorXd::Zero(tree.rates.size());
  hair::outward_velocities(tree.links, tree.rates, tree.passes);
  if (up_to > 1) hair::inward_inertias(tree.links, tree.Q, tree.passes);
  if (up_to > 2) hair::outward_accelerations(tree.links, tree.Q, tree.passes, accelerations);
  return accelerations;
}

double roundings(const Tree& tree) {
  return 100 * static_cast<double>(tree.links.size()) * kUnit;
}

double force_size(const Tree& tree) {
  const Sizes sizes = sizes_of(tree);
  double size = tree.Q.norm() / 0.1;
  for (const LinkPass& pass : tree.passes)
    size += pass.bias.force.norm() + pass.bias.torque.norm() / 0.1 +
            sizes.mass * (pass.c.linear.norm() + sizes.length * pass.c.angular.norm());
  return size;
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
  // A joint's own rates count, too, since they may cancel in the velocities of two links.
  sizes.turn += tree.rates.norm();
  sizes.speed += tree.rates.norm() + sizes.turn * sizes.length;
  return sizes;
}

double accelerations_size(const Tree& tree, const Sizes& sizes, const VectorXd& joints) {
  double size = joints.norm() * std::max(1.0, sizes.length) + sizes.acceleration();
  for (const LinkPass& pass : tree.passes)
    size += pass.a.linear.norm() + sizes.length * pass.a.angular.norm();
  return size;
}

}  // namespace grader::h7
