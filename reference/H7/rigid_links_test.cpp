// STAFF ONLY. H7 beyond its public checks: long fast chains and uneven masses keep their digits,
// and given trees are placed as their shapes say.

#include "hair/rigid_links.h"

#include <gtest/gtest.h>

#include "reference/H7/link_trees_for_tests.h"

namespace reference_tests {
namespace {

using hair::JointType, hair::LinkTree, hair::TreeMotion;

constexpr JointType kRevolute = JointType::revolute, kPrismatic = JointType::prismatic,
                    kSpherical = JointType::spherical;

VectorXd random_vector(int size, double scale, RandomNumbers& numbers) {
  VectorXd values(size);
  for (double& value : values) value = numbers.between(-scale, scale);
  return values;
}

// A lower bound of M's largest eigenvalue, by the power method: M times a vector is the Q of these
// accelerations at rest.
double largest_eigenvalue(const TreeMotion& motion) {
  const VectorXd none = VectorXd::Zero(motion.tree().rates());
  TreeMotion resting = motion;
  for (hair::Link& link : resting.links) link.external = {};
  VectorXd direction = VectorXd::LinSpaced(none.size(), 1, 2).normalized();
  double size = 0;
  for (int k = 0; k < 10; ++k) {
    direction = joint_forces(resting, {}, none, direction);
    size = direction.norm();
    direction /= size;
  }
  return size;
}

// Compares Newton's and Euler's laws with the passes: the residual of M q" + C = Q over the sizes of its
// terms.
double residual(TreeMotion& motion, const VectorXd& rates, const VectorXd& Q) {
  VectorXd a(Q.size());
  accelerate(motion, rates, Q, a);
  const VectorXd C = joint_forces(motion, {}, rates, VectorXd::Zero(a.size()));
  return (joint_forces(motion, {}, rates, a) - Q).norm() /
         (largest_eigenvalue(motion) * a.norm() + C.norm() + Q.norm());
}

// Each of 25 to 1,000 joints spins. Some programs lose all digits in such fast chains.
TEST(RigidLinks, LongFastChainsKeepTheirDigits) {
  for (const int links : {25, 100, 300, 1000})
    for (const double speed : {1.0, 1e3}) {
      RandomNumbers numbers(links);
      const LinkTree tree = rod_chain(links, 0.01, 1e-7, 5e-5);
      TreeMotion motion(tree);
      const VectorXd q = random_coordinates(tree, numbers),
                     rates = random_vector(tree.rates(), speed, numbers);
      const VectorXd Q = random_vector(tree.rates(), 1e-12, numbers);
      motion.place({}, q);
      add_weight(Vector3d(0, 0, -9.81), motion);
      EXPECT_LE(residual(motion, rates, Q), 1e-15 * links) << links << " links at " << speed << " rad/s";
    }
}

// A light link hangs between heavy ones, or a heavy one between light ones.
TEST(RigidLinks, MassesMayDifferByAMillion) {
  for (const bool light_first : {true, false}) {
    RandomNumbers numbers(11);
    const LinkTree even = random_tree(20, {kRevolute, kPrismatic, kSpherical}, true, numbers);
    std::vector<hair::LinkShape> shapes(even.shapes().begin() + 1, even.shapes().end());
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if ((i % 2 == 0) == light_first) {
        shapes[i].mass *= 1e-6;
        shapes[i].moments *= 1e-6;
      }
    const LinkTree tree(shapes);
    TreeMotion motion(tree);
    const VectorXd q = random_coordinates(tree, numbers), rates = random_vector(tree.rates(), 5, numbers);
    motion.place({}, q);
    EXPECT_LE(residual(motion, rates, random_vector(tree.rates(), 1, numbers)), 1e-13 * 20)
        << (light_first ? "light" : "heavy") << " links first";
  }
}

// This checks the places of the links that go into the passes, since the passes themselves don't use places.
TEST(TreeMotion, PlacesEachLinkAtItsParent) {
  RandomNumbers numbers(6);
  const LinkTree tree = random_tree(20, {kRevolute, kPrismatic, kSpherical}, false, numbers);
  const VectorXd q = random_coordinates(tree, numbers);
  TreeMotion motion(tree);
  hair::TreeBase base;
  base.position = numbers.vector(3);
  base.orientation = numbers.turn();
  motion.place(base, q);
  std::vector<Eigen::Isometry3d> places = {Eigen::Translation3d(base.position) * base.orientation};
  for (int i = 1; i < tree.links(); ++i) {
    const hair::LinkShape& shape = tree.shapes()[i];
    Eigen::Isometry3d joint = places[shape.parent] * Eigen::Translation3d(shape.joint_at) * shape.rest;
    const double* at = q.data() + tree.coordinate(i);
    if (shape.joint == kRevolute) joint = joint * Eigen::AngleAxisd(*at, shape.axis);
    if (shape.joint == kPrismatic) joint = joint * Eigen::Translation3d(*at * shape.axis);
    if (shape.joint == kSpherical) joint = joint * Eigen::Quaterniond(at);
    places.push_back(joint * Eigen::Translation3d(shape.center));
    const hair::LinkFrame& frame = motion.frames()[i];
    const double bound = 1e-13;  // rounding of some 20 products, within 20 m
    EXPECT_LE((frame.position - places[i].translation()).norm(), bound) << "link " << i;
    EXPECT_LE((frame.axes - places[i].linear()).norm(), bound) << "link " << i;
  }
}

}  // namespace
}  // namespace reference_tests
