// STAFF ONLY. H7's three passes, one after the other, each with what the student's own pass before it found.
//
// Bound: M q" = Q - C to within 1e-7 of all forces that take part. The recursion about centres of mass leaves 1e-15 a link.
// A right formula may refer all links to one point. With links 10 m from it, whose radius of gyration is 0.3 m, the numbers
// in s'I^A s are 1e3 times as large as what is left of them, and so are those that a gain multiplies: 1e6 times 10 n u. A
// forgotten term leaves 1e-4 and more.
#include <cmath>

#include "grader/exercise/H7/answers.h"
#include "grader/exercise/H7/cases.h"
#include "grader/exercise/H7/trees.h"

namespace grader::h7 {
namespace {

constexpr double kBalanced = 1e-7;

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

// Checks that accelerations obey the laws of motion: without H7's recursion, link by link from Newton's and Euler's laws (Mirtich 4.4 and
// 4.5 solve for the same accelerations). The joints' forces that `accelerations` need, beside Q: the largest difference over `size`, the
// sum of all forces and torques that take part, with their arms. M(q) q" = Q - C to within this. NaN if an acceleration is none.
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

// What the three passes find. Only what a pass is said to set is taken from it.
VectorXd three_passes(Trial& trial, Tree& tree) {
  const Answered first = ask(trial, 1, tree);
  for (std::size_t i = 1; i < tree.links.size(); ++i) {
    tree.passes[i].v = first.passes[i].v;
    tree.passes[i].c = first.passes[i].c;
    tree.passes[i].bias = first.passes[i].bias;
  }
  const Answered second = ask(trial, 2, tree);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    tree.passes[i].bias = second.passes[i].bias;
    tree.passes[i].inertia = second.passes[i].inertia;
    if (i > 0) tree.passes[i].gain = second.passes[i].gain;
  }
  return ask(trial, 3, tree).accelerations;
}

void expect_balanced(Trial& trial, const TreeKind& kind, const std::string& what) {
  Tree tree = random_tree(trial.random, kind);
  const VectorXd accelerations = three_passes(trial, tree);
  trial.expect_at_most(unbalanced(tree, accelerations), kBalanced, what);
}

}  // namespace

void equations_of_motion(Trial& trial) {
  for (int links : {1, 2, 4, 10, 30})
    for (const bool stiffens : {false, true})
      expect_balanced(trial, {.links = links, .types = kRequired, .stiffens = stiffens},
                      "what M(q) q\" = Q - C leaves");
}

void trees(Trial& trial) {
  for (int links : {2, 4, 8, 25})
    expect_balanced(trial, {.links = links, .types = kRequired, .branches = true},
                    "what M(q) q\" = Q - C leaves, of a tree,");
}

void long_chains(Trial& trial) {
  expect_balanced(trial, {.links = 1000, .types = kRequired, .speed = 0.1},
                  "what M(q) q\" = Q - C leaves, of 1,000 links,");
  expect_balanced(trial, {.links = 20, .types = kRequired, .lightest = 1e-6},
                  "what M(q) q\" = Q - C leaves, of links that are a million times as heavy as others,");
  expect_balanced(trial, {.links = 25, .types = kRequired, .speed = 1e3},
                  "what M(q) q\" = Q - C leaves, of fast links,");
}

void spherical_joints(Trial& trial) {
  for (int links : {1, 3, 6, 10})
    for (const bool stiffens : {false, true})
      expect_balanced(trial,
                      {.links = links, .types = kSpherical, .branches = links == 6, .stiffens = stiffens},
                      "what M(q) q\" = Q - C leaves, with spherical joints,");
}

}  // namespace grader::h7
