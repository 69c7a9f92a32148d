// STAFF ONLY. H7's passes 1 and 3, each alone.
//
// Bounds: a velocity is a sum of n joints' parts, each rounded some ten times. A right formula may refer them
// to any point of the tree, so its numbers have the sizes of Sizes. 100 n u of these covers the rounding, and
// a missing term is as large as they are. Pass 3 solves for accelerations, q" = gain (Q - s'(I^A a^ + Z^A)),
// and a gain may belong to an inertia of a ten thousandth of I^A: 1e-8 of the largest.
#include <cmath>

#include "reference/H7/answers.h"

namespace grader::h7 {
namespace {

// Compares one of the motions that pass 1 finds, for chains of all lengths.
void expect_pass_1(Trial& trial, hair::SpatialMotion LinkPass::*member, double (*size)(const Sizes&),
                   const std::string& what) {
  for (int links : {1, 2, 3, 5, 8, 30})
    for (const auto* types : {&kRevolute, &kRequired}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = *types});
      const Sizes sizes = sizes_of(tree);
      const Answered answered = ask(trial, 1, tree);
      reference_passes(tree, 1);
      expect_motions(trial, answered.passes, tree.passes, member, sizes.length, roundings(tree) * size(sizes),
                     what);
    }
}

}  // namespace

void velocities(Trial& trial) {
  expect_pass_1(
      trial, &LinkPass::v, [](const Sizes& sizes) { return sizes.speed; }, "the velocity of a link");
}

void moving_joints(Trial& trial) {
  expect_pass_1(
      trial, &LinkPass::c, [](const Sizes& sizes) { return sizes.acceleration(); }, "c^ of a link");
}

void link_forces(Trial& trial) {
  for (int links : {1, 3, 6, 30})
    for (const bool moves : {false, true}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = kRequired, .moves = moves});
      const Sizes sizes = sizes_of(tree);
      const Answered answered = ask(trial, 1, tree);
      reference_passes(tree, 1);
      // Moments of inertia are below 0.2 kg m^2, forces and torques below 100 N and N m.
      const double size = 100 + sizes.turn * sizes.turn;
      expect_forces(trial, answered.passes, tree.passes, 1, 1, roundings(tree) * size, "Z^ of a link");
    }
}

void accelerations(Trial& trial) {
  for (int links : {1, 2, 3, 5, 8, 30})
    for (const bool moves : {false, true}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = kRequired, .moves = moves});
      const Sizes sizes = sizes_of(tree);
      reference_passes(tree, 2);
      const Answered answered = ask(trial, 3, tree);
      const VectorXd expected = [&] {
        Tree again = tree;
        const VectorXd found = reference_passes(again, 3);
        tree.passes = again.passes;
        return found;
      }();
      double size = expected.norm() * std::max(1.0, sizes.length) + sizes.acceleration();
      for (const LinkPass& pass : tree.passes)
        size += pass.a.linear.norm() + sizes.length * pass.a.angular.norm();
      trial.expect_close({answered.accelerations, expected, 1}, 1e-8 * size, "an acceleration of a joint");
      expect_motions(trial, answered.passes, tree.passes, &LinkPass::a, 1, 1e-8 * size,
                     "the acceleration of a link");
    }
}

}  // namespace grader::h7
