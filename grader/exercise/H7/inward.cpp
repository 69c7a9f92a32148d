// STAFF ONLY. H7's pass 2 alone, and gains.
//
// Bounds: I^A never exceeds the inertia of all links as one body, I. An error of a child's I^A that is at most e I^A, as a
// quadratic form, is at most e of the parent's, because what a joint lets through is a projection in I^A's own norm. A
// rounding is u of the largest number, and so u cond(I^A) as a form; with the links that are taken here the condition
// number stays below 1e5. Some 10 roundings at each of n <= 9 links: 1e-9 of I. Bias forces are made by the same
// projections, and gains are sums of I^A's numbers along the joint.
#include <cmath>

#include "grader/exercise/H7/answers.h"
#include "grader/exercise/H7/cases.h"

namespace grader::h7 {
namespace {

constexpr double kRoundings = 1e-9;

// The greatest force that passes through a joint: all that is on links, what their c^ needs, and Q over the arm that a
// joint has at least.
double force_size(const Tree& after_pass_1) {
  const Sizes sizes = sizes_of(after_pass_1);
  double size = after_pass_1.Q.norm() / 0.1;
  for (const LinkPass& pass : after_pass_1.passes)
    size += pass.bias.force.norm() + pass.bias.torque.norm() / 0.1 +
            sizes.mass * (pass.c.linear.norm() + sizes.length * pass.c.angular.norm());
  return size;
}

}  // namespace

void inertias(Trial& trial) {
  for (int links : {1, 2, 3, 5, 8})
    for (const auto* types : {&kRevolute, &kRequired}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = *types, .moves = false});
      // The base has an inertia, too, and what a pass had before is nobody's.
      tree.links[0].inertia = tree.links[1].inertia;
      for (LinkPass& pass : tree.passes) pass.inertia = tree.links.back().inertia;
      const Sizes sizes = sizes_of(tree);
      reference_passes(tree, 1);
      const Answered answered = ask(trial, 2, tree);
      reference_passes(tree, 2);
      trial.expect_at_most(inertia_error(answered.passes, tree.passes, sizes.length), kRoundings * sizes.mass,
                           "I^A of a link");
    }
}

void biases(Trial& trial) {
  for (int links : {1, 2, 3, 5, 8})
    for (const bool moves : {false, true}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = kRequired, .moves = moves});
      const double length = sizes_of(tree).length;
      reference_passes(tree, 1);
      const double size = force_size(tree);
      const Answered answered = ask(trial, 2, tree);
      reference_passes(tree, 2);
      trial.expect_at_most(force_error(answered.passes, tree.passes, length, 0), kRoundings * size,
                           "Z^A of a link");
    }
}

void gains(Trial& trial) {
  for (int links : {1, 2, 4, 7})
    for (const bool stiffens : {false, true}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = kRequired, .stiffens = stiffens});
      const double length = sizes_of(tree).length, mass = sizes_of(tree).mass;
      reference_passes(tree, 1);
      const double size = force_size(tree);
      const Answered answered = ask(trial, 2, tree);
      reference_passes(tree, 2);
      for (std::size_t i = 1; i < tree.links.size(); ++i) {
        const double expected = tree.passes[i].gain(0, 0);
        trial.expect_at_most(std::abs(answered.passes[i].gain(0, 0) - expected), 100 * kRoundings * expected,
                             stiffens ? "the gain of a joint that is stiffened" : "the gain of a joint");
      }
      trial.expect_at_most(inertia_error(answered.passes, tree.passes, length), kRoundings * mass,
                           "I^A beside joints that are stiffened");
      trial.expect_at_most(force_error(answered.passes, tree.passes, length, 0), kRoundings * size,
                           "Z^A beside joints that are stiffened");
    }
}

}  // namespace grader::h7
