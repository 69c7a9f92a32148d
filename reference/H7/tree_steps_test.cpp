// STAFF ONLY. H7 in motion: trees of links, their springs and their steps against closed forms.

#include "hair/rigid_links/tree_steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/H7/link_trees_for_tests.h"
#include "solver/test_allocations.h"
#include "solver/test_numbers.h"

namespace reference_tests {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond;
using hair::JointType, hair::LinkShape, hair::LinkTree, hair::TreeBase, hair::TreeForces, hair::TreeSteps,
    hair::TreeSystem;

TreeForces weight() {
  TreeForces forces;
  forces.gravity = Vector3d(0, 0, -kGravity);
  return forces;
}

VectorXd accelerations(TreeSystem& system, const VectorXd& q) {
  const VectorXd rates = VectorXd::Zero(system.tree().rates());
  VectorXd a(rates.size());
  system.accelerations({}, q, rates, 0, {}, a);
  return a;
}

using Step = void (TreeSteps::*)(const TreeBase&, double, std::span<const hair::LinkForce>, hair::Output,
                                 hair::Output);

struct MovingTree {
  VectorXd q, rates;
};

MovingTree after(TreeSteps& steps, Step step, MovingTree moving, double time, int count) {
  for (int k = 0; k < count; ++k) (steps.*step)({}, time / count, {}, moving.q, moving.rates);
  return moving;
}

double energy(TreeSteps& steps, const MovingTree& moving) {
  VectorXd a(moving.rates.size());
  steps.system().accelerations({}, moving.q, moving.rates, 0, {}, a);
  return steps.system().kinetic_energy() + steps.system().potential_energy(moving.q);
}

// The energy that a free tree gains or loses in a second falls with the method's order.
TEST(TreeSteps, TheEnergyOfAFreeTreeDriftsAtTheMethodsOrder) {
  RandomNumbers numbers(4);
  const LinkTree tree =
      random_tree(12, {JointType::revolute, JointType::spherical, JointType::prismatic}, false, numbers);
  MovingTree start{random_coordinates(tree, numbers), VectorXd(tree.rates())};
  for (double& rate : start.rates) rate = numbers.between(-1, 1);
  TreeForces forces = weight();
  forces.springs.resize(tree.links());
  for (hair::JointSpring& spring : forces.springs) spring.stiffness = 20 * Matrix3d::Identity();
  for (const auto& [step, order, coarse] : {std::tuple{&TreeSteps::symplectic_euler, 1.0, 4000},
                                            std::tuple{&TreeSteps::linearly_implicit_euler, 1.0, 4000},
                                            std::tuple{&TreeSteps::runge_kutta_4, 4.0, 500}}) {
    TreeSteps steps(tree, forces);
    const double first = energy(steps, start);
    const double drift = std::abs(energy(steps, after(steps, step, start, 0.5, coarse)) - first);
    const double half = std::abs(energy(steps, after(steps, step, start, 0.5, 2 * coarse)) - first);
    EXPECT_GE(std::log2(drift / half), order - 0.3) << drift << " J, " << half << " J";
    EXPECT_LE(half, 1e-2 * std::abs(first));
  }
}

// A free rod turns many times about its own axis, and its quaternion is that of the turn.
TEST(TreeSteps, ASphericalJointGoesThroughFullTurns) {
  TreeSteps steps(rod_chain(1, 0.01, 1e-7, 5e-5), {});
  MovingTree moving{steps.system().tree().rest(), Vector3d(0, 0, 40)};
  const double time = 1.7;
  for (const Step step : {&TreeSteps::symplectic_euler, &TreeSteps::linearly_implicit_euler}) {
    const MovingTree end = after(steps, step, moving, time, 100);
    const Quaterniond exact(Eigen::AngleAxisd(40 * time, Vector3d::UnitZ()));
    EXPECT_NEAR(std::abs(exact.coeffs().dot(end.q)), 1, 1e-12);
    EXPECT_NEAR(end.q.norm(), 1, 1e-15);
    EXPECT_LE((end.rates - moving.rates).norm(), 1e-12 * 40);
  }
}

// Compares Q with -dE/dq along each axis, by central differences with errors of e^2 and 1e-16 / e.
TEST(TreeSteps, ASpringsTorqueIsItsEnergysDerivative) {
  const LinkTree tree = rod_chain(1, 0.3, 0.1, 0.05);
  RandomNumbers numbers(9);
  TreeForces forces;
  forces.springs.resize(2);
  const Matrix3d half = Matrix3d::NullaryExpr([&] { return numbers.between(-1, 1); });
  forces.springs[1].stiffness = half * half.transpose();
  TreeSystem system(tree, forces);
  TreeBase base;
  base.orientation = numbers.turn();
  for (const double size : {0.0, 1e-6, 1e-3, 1.0, 2.5, 3.1}) {
    const Quaterniond q = hair::turn_by(size * numbers.direction());
    VectorXd a(3);
    system.accelerations(base, q.coeffs(), Vector3d::Zero(), 0, {}, a);
    const VectorXd torque = joint_forces(system.motion(), base, Vector3d::Zero(), a);
    const double e = 1e-5;
    for (int k = 0; k < 3; ++k) {
      VectorXd there = q.coeffs(), back = there;
      system.motion().turn(Vector3d::Unit(k), e, there);
      system.motion().turn(Vector3d::Unit(k), -e, back);
      const double slope = (system.potential_energy(there) - system.potential_energy(back)) / (2 * e);
      EXPECT_NEAR(-slope, torque[k], 1e-8) << "turned by " << size;
    }
  }
}

// A rod on a torsion spring has theta = theta_0 cos(omega t). Implicit steps damp; their error is of first
// order.
TEST(TreeSteps, ATorsionalOscillatorKeepsItsTime) {
  const LinkTree tree = rod_chain(1, 0.01, 1e-7, 5e-5);
  const double k = 1e-6, omega = std::sqrt(k / tree.shapes()[1].moments.z()), start = 2.0, time = 1.3 / omega;
  TreeForces forces;
  forces.springs.resize(2);
  forces.springs[1].stiffness = k * Matrix3d::Identity();
  TreeSteps steps(tree, forces);
  MovingTree moving{hair::turn_by(Vector3d(0, 0, start)).coeffs(), Vector3d::Zero()};
  for (const auto& [step, order, coarse] : {std::tuple{&TreeSteps::symplectic_euler, 1.0, 500},
                                            std::tuple{&TreeSteps::linearly_implicit_euler, 1.0, 500},
                                            std::tuple{&TreeSteps::runge_kutta_4, 4.0, 20}}) {
    double errors[2];
    for (const int fine : {0, 1}) {
      const MovingTree end = after(steps, step, moving, time, coarse << fine);
      errors[fine] =
          std::abs(hair::turn_of(Quaterniond(Eigen::Vector4d(end.q))).z() - start * std::cos(omega * time));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), order, 0.1);
    EXPECT_LE(errors[1], 5e-3);
  }
}

// One linearly implicit step of a torsion spring solves (J + h^2 k) a = -k (theta + h w).
TEST(TreeSteps, ALinearlyImplicitStepIsItsEquation) {
  const LinkTree tree = rod_chain(1, 0.01, 1e-7, 5e-5);
  const double k = 3e-6, h = 1e-3, J = tree.shapes()[1].moments.z(), theta = 0.7, w = 50;
  TreeForces forces;
  forces.springs.resize(2);
  forces.springs[1].stiffness = k * Matrix3d::Identity();
  TreeSteps steps(tree, forces);
  VectorXd q = hair::turn_by(Vector3d(0, 0, theta)).coeffs(), rates = Vector3d(0, 0, w);
  steps.linearly_implicit_euler({}, h, {}, q, rates);
  const double after = w - h * k * (theta + h * w) / (J + h * h * k);
  EXPECT_NEAR(rates[2], after, 1e-12 * w);
}

// One rod with a limit, in any of the ways that a joint moves.
struct Limited {
  JointType joint;
  TreeSteps steps;
  VectorXd q, rates;

  static constexpr double kUpper = 0.4, kStiffness = 2e-3, kMass = 1e-5, kLength = 0.1;

  static TreeForces forces(double gravity) {
    TreeForces forces;
    forces.gravity = Vector3d(0, 0, -gravity);
    forces.springs.resize(2);
    forces.springs[1].upper = kUpper;
    forces.springs[1].lower = -kUpper;
    forces.springs[1].limit_stiffness = kStiffness;
    return forces;
  }
  static LinkTree tree(JointType joint) {
    LinkShape shape;
    shape.joint = joint;
    shape.axis = joint == JointType::prismatic ? Vector3d(0, 0, -1) : Vector3d(0, 1, 0);
    if (joint != JointType::prismatic)
      shape.center = Vector3d(kLength, 0, 0);  // level: its weight turns it about y
    shape.mass = kMass;
    shape.moments = Vector3d::Constant(1e-9);
    return LinkTree({shape});
  }

  Limited(JointType type, double gravity)
      : joint(type), steps(tree(type), forces(gravity)), q(steps.system().tree().rest()) {
    rates = VectorXd::Zero(steps.system().tree().rates());
  }
  void put(double place) {
    if (joint == JointType::spherical)
      q = hair::turn_by(Vector3d(0, place, 0)).coeffs();
    else
      q[0] = place;
  }
  double place() const {
    return joint == JointType::spherical ? hair::turn_of(Quaterniond(Eigen::Vector4d(q))).y() : q[0];
  }
  double energy() {
    accelerations(steps.system(), q);
    return steps.system().potential_energy(q);
  }
};

constexpr JointType kEachJoint[] = {JointType::revolute, JointType::prismatic, JointType::spherical};

TEST(TreeSteps, ALimitIsASpringBeyondIt) {
  for (const JointType joint : kEachJoint) {
    Limited one(joint, 0);
    const int rate = joint == JointType::spherical ? 1 : 0;
    const double mass = joint == JointType::prismatic
                            ? Limited::kMass
                            : 1e-9 + Limited::kMass * Limited::kLength * Limited::kLength;
    for (const double place : {-0.7, -0.3, 0.3, 0.39, 0.5, 2.0}) {
      one.put(place);
      const double beyond = std::abs(place) - Limited::kUpper;
      const double force = beyond > 0 ? -std::copysign(Limited::kStiffness * beyond, place) : 0;
      EXPECT_NEAR(mass * accelerations(one.steps.system(), one.q)[rate], force, 1e-14) << place;
      const double energy = beyond > 0 ? Limited::kStiffness * beyond * beyond / 2 : 0;
      EXPECT_NEAR(one.energy(), energy, 1e-15) << place;
    }
  }
}

// The weight falls on the buffer and comes to rest there, also where h^2 k is thousands of times the inertia.
// Small steps damp so little that it still bounces.
TEST(TreeSteps, ALimitHoldsAtAnyStep) {
  for (const JointType joint : kEachJoint)
    for (const double h : {1e-3, 1.0 / 60, 0.5}) {
      Limited one(joint, kGravity);
      double farthest = 0;
      for (int n = 0; n < 4000; ++n) {
        one.steps.linearly_implicit_euler({}, h, {}, one.q, one.rates);
        farthest = std::max(farthest, one.place());
      }
      const double pull = Limited::kMass * kGravity, k = Limited::kStiffness;
      double rest = Limited::kUpper + pull / k;
      if (joint != JointType::prismatic)
        for (int n = 0; n < 60; ++n) rest = Limited::kUpper + pull * Limited::kLength * std::cos(rest) / k;
      if (h > 1e-3) {
        EXPECT_NEAR(one.place(), rest, 1e-6) << h;
      }
      // A mass that falls on a spring without damping goes at most twice as deep as its rest, plus the depth
      // from a fall of kUpper.
      EXPECT_LE(farthest, rest + std::sqrt(2 * pull * Limited::kUpper / k) + pull / k) << h;
    }
}

// A joint that is a little beyond its limit, and falls back inside within the step, falls freely: a limit
// does not pull.
TEST(TreeSteps, ALimitLetsGo) {
  for (const JointType joint : kEachJoint) {
    Limited one(joint, -kGravity), free(joint, -kGravity);
    one.put(Limited::kUpper + 1e-4);
    free.put(Limited::kUpper + 1e-4);
    one.steps.linearly_implicit_euler({}, 1.0 / 60, {}, one.q, one.rates);
    TreeForces forces = Limited::forces(-kGravity);
    forces.springs.clear();
    TreeSteps unlimited(Limited::tree(joint), forces);
    unlimited.linearly_implicit_euler({}, 1.0 / 60, {}, free.q, free.rates);
    EXPECT_EQ(one.rates, free.rates);
    EXPECT_LT(one.place(), Limited::kUpper);
  }
}

// A link on a slide, with only drag and weight, reaches the terminal velocity with any step: m g = drag l v.
TEST(TreeSteps, DragEndsAFallAtAnyStep) {
  LinkShape shape;
  shape.joint = JointType::prismatic;
  shape.axis = Vector3d(0, 0, 1);
  shape.mass = 1e-7;
  TreeForces forces = weight();
  forces.drag = 1e-3;
  forces.rods.assign(2, Vector3d(0, 0, 0.01));
  for (const double h : {1e-4, 1.0 / 60, 10.0}) {
    TreeSteps steps{LinkTree({shape}), forces};
    VectorXd q = VectorXd::Zero(1), rates = VectorXd::Zero(1);
    for (int n = 0; n < 1000; ++n) steps.linearly_implicit_euler({}, h, {}, q, rates);
    EXPECT_NEAR(rates[0], -shape.mass * kGravity / (1e-3 * 0.01), 1e-3 * 0.1);
  }
}

TEST(TreeSteps, AllocateNothing) {
  RandomNumbers numbers(2);
  const LinkTree tree = random_tree(20, {JointType::revolute, JointType::spherical}, false, numbers);
  TreeForces forces = weight();
  forces.springs.resize(tree.links());
  forces.rods.assign(tree.links(), Vector3d(0, 0, 1));
  forces.drag = 1;
  TreeSteps steps(tree, forces);
  VectorXd q = random_coordinates(tree, numbers), rates = VectorXd::Zero(tree.rates());
  const hair::LinkForce pull{3, Vector3d(1, 0, 0), Vector3d(0, 1, 0), Matrix3d::Identity(), Matrix3d::Zero()};
  const long before = allocations();
  for (const Step step :
       {&TreeSteps::symplectic_euler, &TreeSteps::linearly_implicit_euler, &TreeSteps::runge_kutta_4})
    (steps.*step)({}, 1e-3, {&pull, 1}, q, rates);
  EXPECT_EQ(allocations(), before);
}

TEST(LinkTree, RefusesWhatCannotMove) {
  const auto refusal = [](auto change) -> std::string {
    LinkShape shape;
    shape.joint = JointType::spherical;
    shape.center = Vector3d(0, 0, 0.1);
    shape.mass = 1;
    shape.moments = Vector3d(0.01, 0.01, 1e-6);
    change(shape);
    try {
      LinkTree tree({shape});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(refusal([](LinkShape&) {}), "nothing");
  EXPECT_EQ(refusal([](LinkShape& s) { s.mass = 0; }).substr(0, 23), "the mass of link 1 is 0");
  EXPECT_EQ(refusal([](LinkShape& s) { s.moments.setZero(); }).substr(0, 62),
            "the least moment of inertia about its joint of link 1 is 0; it");
  EXPECT_NE(refusal([](LinkShape& s) { s.moments.setZero(), s.center.setZero(); }), "nothing");
  EXPECT_NE(refusal([](LinkShape& s) { s.moments[0] = -1; }), "nothing");
  EXPECT_NE(refusal([](LinkShape& s) { s.parent = 1; }), "nothing");
  EXPECT_NE(refusal([](LinkShape& s) { s.joint_at[1] = NAN; }), "nothing");
  EXPECT_NE(refusal([](LinkShape& s) { s.rest.coeffs() *= 2; }), "nothing");
  const auto hinge = [](LinkShape& s) {
    s.joint = JointType::revolute, s.axis = Vector3d(0, 0, 1), s.moments.setZero();
  };
  EXPECT_NE(refusal(hinge), "nothing") << "a point on the axis that it turns about";
}

}  // namespace
}  // namespace reference_tests
