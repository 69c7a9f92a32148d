// STAFF ONLY. H7's three passes, one after the other, each with what the student's own pass before it found.
//
// Bound: M q" = Q - C to within 1e-7 of all forces that take part. The recursion about centres of mass leaves 1e-15 a link.
// A right formula may refer all links to one point. With links 10 m from it, whose radius of gyration is 0.3 m, the numbers
// in s'I^A s are 1e3 times as large as what is left of them, and so are those that a gain multiplies: 1e6 times 10 n u. A
// forgotten term leaves 1e-4 and more.
#include "grader/exercise/H7/answers.h"
#include "grader/exercise/H7/cases.h"
#include "grader/exercise/H7/newton_euler.h"
#include "grader/exercise/H7/trees.h"

namespace grader::h7 {
namespace {

constexpr double kBalanced = 1e-7;

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
