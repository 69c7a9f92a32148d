// STAFF ONLY. H7: the passes against the equations of motion, made in other ways.

#include "hair/rigid_links.h"

#include <gtest/gtest.h>

#include "reference/tests/link_trees.h"
#include "solver/tests/allocations.h"

namespace reference_tests {
namespace {

using hair::JointType, hair::LinkTree, hair::TreeBase, hair::TreeMotion;

struct JointCase {
  const char* name;
  std::vector<JointType> types;
};
const std::vector<JointCase>& cases() {
  static const std::vector<JointCase> all = {
      {"revolute", {JointType::revolute}},
      {"prismatic", {JointType::prismatic}},
      {"spherical", {JointType::spherical}},
      {"all", {JointType::revolute, JointType::prismatic, JointType::spherical}}};
  return all;
}

VectorXd random_vector(int size, double scale, RandomNumbers& numbers) {
  VectorXd values(size);
  for (double& value : values) value = numbers.between(-scale, scale);
  return values;
}

// Forces on all links, and at joints what implicit steps add.
void burden(bool stiff, RandomNumbers& numbers, TreeMotion& motion) {
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    motion.links[i].external = {numbers.vector(10), numbers.vector(10)};
    if (!stiff) continue;
    const Eigen::Matrix3d half = Eigen::Matrix3d::NullaryExpr([&] { return numbers.between(-1, 1); });
    motion.links[i].stiffening = half * half.transpose();
  }
}

struct Residual {
  double size, scale;
};

Residual residual(const DenseMotion& dense, const VectorXd& accelerations, const VectorXd& Q) {
  return {(dense.M * accelerations + dense.C - Q).norm(),
          dense.M.norm() * accelerations.norm() + dense.C.norm() + Q.norm()};
}

// M q" + C = Q with M and C from the links' Jacobians.
TEST(RigidLinks, AcceleratesAsTheDenseEquationsOfMotionSay) {
  for (const JointCase& one : cases())
    for (const int links : {1, 2, 3, 7, 20, 100})
      for (unsigned seed = 0; seed < (links == 100 ? 4u : 20u); ++seed) {
        RandomNumbers numbers(1000 * links + seed);
        const LinkTree tree = random_tree(links, one.types, seed % 2, numbers);
        TreeMotion motion(tree);
        const TreeBase base = seed % 4 < 2 ? TreeBase{} : random_base(numbers);
        const VectorXd q = random_coordinates(tree, numbers), rates = random_vector(tree.rates(), 5, numbers);
        const VectorXd Q = random_vector(tree.rates(), 10, numbers);
        motion.place(base, q);
        burden(seed % 3 == 0, numbers, motion);
        VectorXd accelerations(tree.rates());
        accelerate(motion, rates, Q, accelerations);
        const auto [size, scale] = residual(dense_motion(motion, base, q, rates), accelerations, Q);
        EXPECT_LE(size, 1e-13 * links * scale) << one.name << ", " << links << " links, seed " << seed;

        const VectorXd back = joint_forces(motion, base, rates, accelerations);
        EXPECT_LE((back - Q).norm(), 1e-13 * links * scale)
            << "Newton-Euler: " << one.name << ", " << links << " links, seed " << seed;
      }
}

// The two other ways agree, so that none of them is wrong.
TEST(RigidLinks, JacobiansAgreeWithNewtonAndEuler) {
  RandomNumbers numbers(1);
  const LinkTree tree = random_tree(30, cases().back().types, false, numbers);
  TreeMotion motion(tree);
  const TreeBase base = random_base(numbers);
  const VectorXd q = random_coordinates(tree, numbers), rates = random_vector(tree.rates(), 5, numbers);
  motion.place(base, q);
  burden(true, numbers, motion);
  const VectorXd a = random_vector(tree.rates(), 5, numbers);
  const DenseMotion dense = dense_motion(motion, base, q, rates);
  EXPECT_LE((joint_forces(motion, base, rates, a) - dense.M * a - dense.C).norm(),
            1e-13 * (dense.M.norm() * a.norm() + dense.C.norm()));
}

// Pass 1 alone: v^ is how places change, and a^ how v^ does, while the joints go on. Central differences: errors of h^2
// times the third derivative, about 1e4 m/s^3 after 10 links, and rounding of 1e-15 / h.
TEST(RigidLinks, VelocitiesAreThoseOfPlacesAndAccelerationsThoseOfVelocities) {
  const double h = 1e-5;
  for (const JointCase& one : cases()) {
    RandomNumbers numbers(7);
    const LinkTree tree = random_tree(10, one.types, true, numbers);
    TreeMotion now(tree);
    const VectorXd q = random_coordinates(tree, numbers), rates = random_vector(tree.rates(), 2, numbers);
    const VectorXd Q = VectorXd::Zero(tree.rates());
    now.place({}, q);
    VectorXd a(tree.rates());
    accelerate(now, rates, Q, a);
    auto after = [&](double t) {
      // The rates at the middle of the time; those of spherical joints are along axes that their parents turn.
      VectorXd moved = q;
      now.turn(rates + t / 2 * a, t, moved);
      TreeMotion there(tree);
      there.place({}, moved);
      outward_velocities(there.links, rates + t * a, there.passes);
      return there;
    };
    const TreeMotion late = after(h), early = after(-h);
    for (std::size_t i = 1; i < now.links.size(); ++i) {
      const hair::LinkPass& pass = now.passes[i];
      const Vector3d v = (late.frames()[i].position - early.frames()[i].position) / (2 * h);
      EXPECT_LE((v - pass.v.linear).norm(), 1e-6) << one.name << ", link " << i;
      const Vector3d turned = (late.passes[i].v.angular - early.passes[i].v.angular) / (2 * h);
      EXPECT_LE((turned - pass.a.angular).norm(), 1e-5 * (1 + pass.a.angular.norm()))
          << one.name << ", link " << i;
      const Vector3d moved = (late.passes[i].v.linear - early.passes[i].v.linear) / (2 * h);
      EXPECT_LE((moved - pass.a.linear).norm(), 1e-5 * (1 + pass.a.linear.norm()))
          << one.name << ", link " << i;
    }
  }
}

// (4.24) at the base: I^A_0 a^_0 + Z^A_0 is what all links together need.
TEST(RigidLinks, TheBaseFeelsWhatAllLinksNeed) {
  RandomNumbers numbers(3);
  const LinkTree tree = random_tree(25, cases().back().types, false, numbers);
  TreeMotion motion(tree);
  const TreeBase base = random_base(numbers);
  const VectorXd rates = random_vector(tree.rates(), 3, numbers), Q = random_vector(tree.rates(), 3, numbers);
  motion.place(base, random_coordinates(tree, numbers));
  burden(false, numbers, motion);
  VectorXd a(tree.rates());
  outward_velocities(motion.links, rates, motion.passes);
  std::vector<hair::SpatialForce> Z;
  for (const hair::LinkPass& pass : motion.passes) Z.push_back(pass.bias);
  inward_inertias(motion.links, Q, motion.passes);
  outward_accelerations(motion.links, Q, motion.passes, a);

  hair::SpatialForce needed;
  double scale = 0;
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    const hair::SpatialForce force = motion.links[i].inertia * motion.passes[i].a + Z[i];
    needed += to_parent(force, motion.frames()[i].position - base.position);
    scale += force.force.norm() + force.torque.norm();
  }
  const hair::SpatialForce felt = motion.passes[0].inertia * motion.passes[0].a + motion.passes[0].bias;
  EXPECT_LE((felt.force - needed.force).norm(), 1e-12 * scale);
  EXPECT_LE((felt.torque - needed.torque).norm(), 1e-12 * scale);
  const hair::SpatialInertia& I = motion.passes[0].inertia;
  EXPECT_LE((I.M - I.M.transpose()).norm() + (I.J - I.J.transpose()).norm(), 1e-12 * I.J.norm());
}

// That of M by the power method, from below: M times a vector is what this needs at joints that rest.
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

// Fast chains, where some codes lose all digits: each of 25 to 1,000 joints spins.
TEST(RigidLinks, LongFastChainsKeepTheirDigits) {
  for (const int links : {25, 100, 300, 1000})
    for (const double speed : {1.0, 1e3}) {
      RandomNumbers numbers(links);
      const LinkTree tree = rod_chain(links, 0.01, 1e-7, 5e-5);
      TreeMotion motion(tree);
      const TreeBase base;
      const VectorXd q = random_coordinates(tree, numbers),
                     rates = random_vector(tree.rates(), speed, numbers);
      const VectorXd Q = random_vector(tree.rates(), 1e-12, numbers);
      motion.place(base, q);
      add_weight(Vector3d(0, 0, -9.81), motion);
      VectorXd a(tree.rates());
      accelerate(motion, rates, Q, a);
      const VectorXd C = joint_forces(motion, base, rates, VectorXd::Zero(a.size()));
      const double size = (joint_forces(motion, base, rates, a) - Q).norm();
      const double scale = largest_eigenvalue(motion) * a.norm() + C.norm() + Q.norm();
      EXPECT_LE(size, 1e-15 * links * scale) << links << " links at " << speed << " rad/s";
    }
}

// A light link between heavy ones, and the other way round.
TEST(RigidLinks, MassesMayDifferByAMillion) {
  for (const bool light_first : {true, false}) {
    RandomNumbers numbers(11);
    const LinkTree even = random_tree(20, cases().back().types, true, numbers);
    std::vector<hair::LinkShape> shapes(even.shapes().begin() + 1, even.shapes().end());
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if ((i % 2 == 0) == light_first) {
        shapes[i].mass *= 1e-6;
        shapes[i].moments *= 1e-6;
      }
    const LinkTree tree(shapes);
    TreeMotion motion(tree);
    const VectorXd q = random_coordinates(tree, numbers), rates = random_vector(tree.rates(), 5, numbers);
    const VectorXd Q = random_vector(tree.rates(), 1, numbers);
    motion.place({}, q);
    VectorXd a(tree.rates());
    accelerate(motion, rates, Q, a);
    const auto [size, scale] = residual(dense_motion(motion, {}, q, rates), a, Q);
    EXPECT_LE(size, 1e-13 * 20 * scale);
  }
}

TEST(RigidLinks, AllocatesNothing) {
  RandomNumbers numbers(5);
  const LinkTree tree = random_tree(50, cases().back().types, false, numbers);
  TreeMotion motion(tree);
  VectorXd q = random_coordinates(tree, numbers), a(tree.rates());
  const VectorXd rates = random_vector(tree.rates(), 5, numbers), Q = a;
  const long before = allocations();
  motion.place({}, q);
  accelerate(motion, rates, Q, a);
  motion.turn(rates, 0.1, q);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace reference_tests
