// STAFF ONLY. H7's passes, each alone.
//
// Bounds: a velocity is a sum of n joints' parts, each rounded some ten times. A right formula may refer them
// to any point of the tree, so its numbers have the sizes of Sizes. 100 n u of these covers the rounding, and
// a missing term is as large as they are. Pass 3 solves for accelerations, q" = gain (Q - s'(I^A a^ + Z^A)),
// and a gain may belong to an inertia of a ten thousandth of I^A: 1e-8 of the largest.
//
// Pass 2: I^A never exceeds the inertia of all links as one body, I. An error of a child's I^A that is at
// most e I^A, as a quadratic form, is at most e of the parent's, because a joint projects in I^A's own norm.
// A rounding is u of the largest number, and so u cond(I^A) as a form; with the links of these cases the
// condition number stays below 1e5. Some 10 roundings at each of n <= 9 links make 1e-9 of I. Bias forces are
// made by the same projections, and gains are sums of I^A's numbers along the joint.
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
      const VectorXd expected = reference_passes(tree, 3);
      const double size = accelerations_size(tree, sizes, expected);
      trial.expect_close({answered.accelerations, expected, 1}, 1e-8 * size, "an acceleration of a joint");
      expect_motions(trial, answered.passes, tree.passes, &LinkPass::a, 1, 1e-8 * size,
                     "the acceleration of a link");
    }
}

namespace {

constexpr double kRoundings = 1e-9;

// Z^A by (4.29) from a student's own I^A, gains and Z^A of children, so that a wrong I^A costs only its own
// category.
std::vector<LinkPass> biases_of(const Tree& after_pass_1, const std::vector<LinkPass>& own) {
  std::vector<LinkPass> expected = after_pass_1.passes;
  for (std::size_t i = after_pass_1.links.size() - 1; i > 0; --i) {
    const Link& link = after_pass_1.links[i];
    const hair::SpatialMotion s = axis_of(link);
    hair::SpatialForce through = own[i].bias + own[i].inertia * own[i].c;
    const double free = own[i].gain(0, 0) * (after_pass_1.Q[link.first] - dot(s, through));
    through += free * (own[i].inertia * s);
    expected[link.parent].bias += to_parent(through, link.r);
  }
  return expected;
}

// The largest size of I^A, and of gains.
std::pair<double, double> sizes_in(const std::vector<LinkPass>& passes) {
  double inertia = 0, gain = 0;
  for (const LinkPass& pass : passes) {
    inertia = std::max(inertia, pass.inertia.M.norm());
    gain = std::max(gain, std::abs(pass.gain(0, 0)));
  }
  return {inertia, gain};
}

// Pass 3 uses the stiffening only through the gain: relative to the gain, the first joint's acceleration is
// the same.
void expect_gain_taken(Trial& trial, Tree tree) {
  std::array<double, 2> own, ours;
  for (int k = 0; k < 2; ++k) {
    tree.links[1].stiffening(0, 0) = 0.7 * k;
    Tree after = tree;
    reference_passes(after, 2);
    const double gain = after.passes[1].gain(0, 0);
    own[k] = ask(trial, 3, after).accelerations[0] / gain;
    ours[k] = reference_passes(after, 3)[0] / gain;
    trial.expect(comparable(std::abs(own[k]), std::abs(ours[k])), "an acceleration is 0, or much too large");
  }
  trial.expect_at_most(std::abs(own[1] - own[0]), 1e-8 * (std::abs(own[0]) + std::abs(ours[0])),
                       "the acceleration of a stiffened joint, over its gain");
}

}  // namespace

void inertias(Trial& trial) {
  for (int links : {1, 2, 3, 5, 8})
    for (const auto* types : {&kRevolute, &kRequired}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = *types, .moves = false});
      const Sizes sizes = sizes_of(tree);
      reference_passes(tree, 1);
      const Answered answered = ask(trial, 2, tree);
      reference_passes(tree, 2);
      expect_inertias(trial, answered.passes, tree.passes, sizes.length, kRoundings * sizes.mass,
                      "I^A of a link");
      for (int i = 1; i <= links; ++i) {
        const double expected = tree.passes[i].gain(0, 0);
        trial.expect_near(compared(answered.passes[i].gain(0, 0), expected), 100 * kRoundings * expected,
                          "the gain of a joint");
      }
    }
}

void biases(Trial& trial) {
  for (int links : {1, 2, 3, 5, 8})
    for (const bool moves : {false, true}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = kRequired, .moves = moves});
      const double length = sizes_of(tree).length;
      reference_passes(tree, 1);
      const double size = force_size(tree);
      const std::vector<LinkPass> answered = ask(trial, 2, tree).passes, by_own = biases_of(tree, answered);
      const auto [own_inertia, own_gain] = sizes_in(answered);
      reference_passes(tree, 2);
      const auto [inertia, gain] = sizes_in(tree.passes);
      const bool right = force_error(answered, tree.passes, length, 0) <= kRoundings * size,
                 usable = comparable(own_inertia, inertia) && comparable(own_gain, gain);
      expect_forces(trial, answered, right || !usable ? tree.passes : by_own, length, 0, kRoundings * size,
                    "Z^A of a link");
    }
}

// Implicit steps add to the last link's inertia, which does not change Euler's term, and to one joint. If the
// joint is stiffened by b, 1 / gain is larger by b, and its parent's I^A and Z^A are affine in the gain.
void added_by_steps(Trial& trial) {
  const std::vector<JointType> slider = {JointType::prismatic};
  for (const auto& [links, stiffened] : {std::pair{1, 1}, {3, 1}, {3, 3}})
    for (const auto* types : {&kRevolute, &slider}) {
      Tree tree = random_tree(trial.random, {.links = links, .types = *types});
      const std::vector<LinkPass> plain = ask(trial, 1, tree).passes;
      hair::SpatialInertia& added_to = tree.links.back().inertia;
      added_to.M += Vector3d(0.1, 0.5, 0.3).asDiagonal();
      added_to.H(0, 1) += 0.05;
      added_to.J += Vector3d(0.2, 0.1, 0.4).asDiagonal();
      const Sizes sizes = sizes_of(tree);
      expect_forces(trial, ask(trial, 1, tree).passes, plain, 1, 1,
                    roundings(tree) * (100 + sizes.turn * sizes.turn),
                    "Z^ of a link, to whose inertia a step added, beside that without");
      expect_gain_taken(trial, tree);
      reference_passes(tree, 1);
      const double force = force_size(tree);
      std::array<std::vector<LinkPass>, 3> own, ours;
      const std::array<double, 3> added = {0, 0.3, 1.7};
      for (int k = 0; k < 3; ++k) {
        tree.links[stiffened].stiffening(0, 0) = added[k];
        own[k] = ask(trial, 2, tree).passes;
        Tree found = tree;
        reference_passes(found, 2);
        ours[k] = found.passes;
      }
      expect_inertias(trial, {own[0].back()}, {ours[0].back()}, sizes.length, kRoundings * sizes.mass,
                      "I^A of the last link, to whose inertia a step added");
      const auto gain = [at = stiffened](const std::vector<LinkPass>& passes) {
        return passes[at].gain(0, 0);
      };
      if (links == 1)
        trial.expect_near(compared(gain(own[0]), gain(ours[0])), 100 * kRoundings * gain(ours[0]),
                          "the gain of a lone joint, to whose link's inertia a step added");
      for (int k = 1; k < 3; ++k)
        trial.expect_at_most(std::abs(1 / gain(own[k]) - 1 / gain(own[0]) - added[k]),
                             100 * kRoundings * (1 / gain(ours[0]) + added[k]),
                             "by how much 1 / gain grows beside what stiffens a joint");
      for (const auto part : {inertia_of, bias_of}) {
        const int parent = stiffened - 1;
        const auto change = [&](const auto& passes, int k) {
          return VectorXd(part(passes[k][parent], sizes.length) - part(passes[0][parent], sizes.length));
        };
        const VectorXd off =
            change(own, 1) * (gain(own[2]) - gain(own[0])) - change(own, 2) * (gain(own[1]) - gain(own[0]));
        const double size =
            part(ours[0][parent], sizes.length).norm() + (part == bias_of ? force : sizes.mass);
        trial.expect(comparable(change(own, 1).norm(), change(ours, 1).norm()),
                     "a link does not feel that its child's joint is stiffened");
        trial.expect_at_most(off.norm(), kRoundings * size * gain(own[0]),
                             "what a link feels beside a joint that is stiffened");
      }
    }
}

}  // namespace grader::h7
