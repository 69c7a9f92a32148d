// STAFF ONLY. Hidden cases of H7 that compare a student's answer with the student's own answer to another
// question, so that each shows only one kind of mistake.
//
// Bounds: those of each pass's own cases, which also check the exact size. Here an answer must only not be
// 0 where the reference's is not.
#include "reference/H7/answers.h"

namespace grader::h7 {
namespace {

constexpr double kOfPass2 = 1e-9, kOfPass3 = 1e-8;

// The answers of a pass, and the reference's sizes of them.
struct Case {
  int pass;
  Tree tree;
  Sizes sizes;
  double force = 0, acceleration = 0;
};

// The state before a pass: the reference's results of the passes before it.
Case before(int pass, const Tree& tree) {
  Case made{pass, tree, sizes_of(tree)};
  Tree after = tree;
  made.acceleration = reference_passes(after, 3).norm() * std::max(1.0, made.sizes.length);
  for (const LinkPass& link : after.passes)
    made.acceleration += link.a.linear.norm() + made.sizes.length * link.a.angular.norm();
  if (pass > 1) reference_passes(made.tree, pass - 1);
  Tree after_pass_1 = tree;
  reference_passes(after_pass_1, 1);
  made.force = force_size(after_pass_1);
  return made;
}

Answered ask(Trial& trial, const Case& about) {
  return ask(trial, about.pass, about.tree);
}

// Compares two answers about the same links.
void expect_same(Trial& trial, const Case& about, const Answered& answered, const Answered& same,
                 std::size_t first, const std::string& what) {
  const Of &one = answered.passes, &other = same.passes;
  const Sizes& sizes = about.sizes;
  const double outward = roundings(about.tree);
  if (about.pass == 1) {
    expect_motions(trial, one, other, &LinkPass::v, sizes.length, outward * sizes.speed,
                   "the velocity of a link " + what);
    expect_motions(trial, one, other, &LinkPass::c, sizes.length, outward * sizes.acceleration(),
                   "c^ of a link " + what);
    expect_forces(trial, one, other, 1, 1, outward * (100 + sizes.turn * sizes.turn), "Z^ of a link " + what);
  } else if (about.pass == 2) {
    expect_inertias(trial, {one.begin() + first, one.end()}, {other.begin() + first, other.end()},
                    sizes.length, kOfPass2 * sizes.mass, "I^A of a link " + what);
    expect_forces(trial, one, other, sizes.length, first, kOfPass2 * about.force, "Z^A of a link " + what);
  } else {
    expect_motions(trial, one, other, &LinkPass::a, 1, kOfPass3 * about.acceleration,
                   "the acceleration of a link " + what);
    trial.expect_close({answered.accelerations, same.accelerations, 1}, kOfPass3 * about.acceleration,
                       "the acceleration of a joint " + what);
  }
}

// Fails for answers of 0, since those are the same in every tree.
void expect_something(Trial& trial, const Case& about, const Of& answered) {
  Tree tree = about.tree;
  reference_passes(tree, about.pass);
  const auto size = [&](const LinkPass& pass) {
    if (about.pass == 1) return pass.v.linear.norm();
    return about.pass == 2 ? pass.gain.norm() : pass.a.linear.norm();
  };
  trial.expect(comparable(size(answered.back()), size(tree.passes.back())),
               "a pass leaves 0, or numbers a million times as large as they should be");
}

std::vector<int> path_to(const Tree& tree, int link) {
  std::vector<int> path;
  for (; link > 0; link = tree.links[link].parent) path.insert(path.begin(), link);
  path.insert(path.begin(), 0);
  return path;
}

// In pass 2 each of three chains that hang from link 1 is as it is alone, and link 1 gets the sum.
void expect_sum_of_chains(Trial& trial) {
  constexpr int kChains = 3;
  const Case all =
      before(2, random_tree(trial.random, {.links = 10, .types = kRequired, .form = Form::strands}));
  const Of together = ask(trial, all).passes;
  expect_something(trial, all, together);
  Of sum = all.tree.passes;
  sum[1].inertia = all.tree.links[1].inertia;
  for (int chain = 0; chain < kChains; ++chain) {
    std::vector<int> links = {0, 1};
    for (int i = 2 + chain; i < static_cast<int>(all.tree.links.size()); i += kChains) links.push_back(i);
    Case one = all;
    one.tree = part_of(all.tree, links);
    const Of alone = ask(trial, one).passes;
    expect_same(trial, one, {part_of(together, links), {}}, {alone, {}}, 2, "of one of three chains");
    const LinkPass& own = all.tree.passes[1];
    sum[1].bias += alone[1].bias + (-1.0) * own.bias;
    hair::SpatialInertia less = all.tree.links[1].inertia;
    less.M *= -1, less.H *= -1, less.J *= -1;
    sum[1].inertia += alone[1].inertia;
    sum[1].inertia += less;
  }
  const std::vector<int> stem = {0, 1};
  expect_same(trial, all, {part_of(together, stem), {}}, {part_of(sum, stem), {}}, 1,
              "from which three chains hang");
}

void expect_same_in_units(Trial& trial, const Case& about, const Units& units) {
  const Units back{1 / units.mass, 1 / units.length, 1 / units.time};
  const Answered answered = ask(trial, about);
  expect_something(trial, about, answered.passes);
  Tree other = in_units(about.tree, units);
  const Answered in_others = ask(trial, about.pass, other);
  other.passes = in_others.passes;
  // Accelerations are rates of rates.
  if (about.pass == 3) other.rates = units.time * in_others.accelerations;
  const Tree same = in_units(other, back);
  expect_same(trial, about, answered, {same.passes, about.pass == 3 ? same.rates : VectorXd()}, 0,
              "in other units");
}

}  // namespace

void trees(Trial& trial) {
  for (int links : {2, 4, 8, 25})
    for (int pass : {1, 3}) {
      const Case all = before(
          pass, random_tree(trial.random, {.links = links, .types = kRequired, .form = Form::branches}));
      const Answered together = ask(trial, all);
      expect_something(trial, all, together.passes);
      const std::vector<int> path = path_to(all.tree, links);
      Case one = all;
      one.tree = part_of(all.tree, path);
      expect_same(trial, all, part_of(all.tree, together, path), ask(trial, one), 1, "of a tree");
    }
  expect_sum_of_chains(trial);
}

// The last links of 1,000 have the same results as a chain of their own, on a base that moves as the link
// before them.
void long_chains(Trial& trial) {
  const int links = 1000, kept = 8;
  std::vector<int> tip;
  for (int i = links - kept; i <= links; ++i) tip.push_back(i);
  const Tree chain = random_tree(trial.random, {.links = links, .types = kRequired});
  for (int pass : {1, 2, 3}) {
    const Case all = before(pass, chain);
    const Answered whole = ask(trial, all);
    expect_something(trial, all, whole.passes);
    Case one = all;
    one.tree = part_of(all.tree, tip);
    one.tree.passes[0].v = whole.passes[tip[0]].v;
    one.tree.passes[0].a = whole.passes[tip[0]].a;
    one.tree.passes[0].bias = {};
    expect_same(trial, all, part_of(all.tree, whole, tip), ask(trial, one), 1, "of a long chain");
  }
}

// Hair has links of 1e-8 kg, 1 mm and 1e5 rad/s: no threshold in kg, m or s may show.
void other_units(Trial& trial) {
  const Units all_units[] = {
      {.mass = 0x1p-50}, {.length = 0x1p-50}, {.time = 0x1p-30}, {0x1p-60, 0x1p-40, 0x1p50}};
  for (const Units& units : all_units)
    for (int pass : {1, 2, 3})
      expect_same_in_units(trial, before(pass, random_tree(trial.random, {.links = 4, .types = kRequired})),
                           units);
}

// Numbers from before the call do not count in a pass, and the base has an inertia, too.
void values_before(Trial& trial) {
  for (int pass : {1, 2, 3}) {
    const Case clean = before(pass, random_tree(trial.random, {.links = 3, .types = kRequired}));
    const Answered expected = ask(trial, clean);
    expect_something(trial, clean, expected.passes);
    Case used = clean;
    for (std::size_t i = 0; i < used.tree.passes.size(); ++i) {
      LinkPass& link = used.tree.passes[i];
      if (pass == 2) link.inertia = used.tree.links[1].inertia, link.gain(0, 0) = 1;
      if (i == 0) continue;
      link.a = {Vector3d(1, 2, 3), Vector3d(4, 5, 6)};
      if (pass == 1) link.v = link.c = link.a, link.bias = {Vector3d(3, 2, 1), Vector3d(6, 5, 4)};
    }
    expect_same(trial, clean, ask(trial, used), expected, 0,
                "when its passes[i] held other values before the call");
  }
  Case heavy = before(2, random_tree(trial.random, {.links = 2, .types = kRequired}));
  const Of light = ask(trial, heavy).passes;
  heavy.tree.links[0].inertia = heavy.tree.links[1].inertia;
  heavy.tree.links[0].tensor = heavy.tree.links[1].tensor;
  Of expected = light;
  expected[0].inertia += heavy.tree.links[0].inertia;
  expect_same(trial, heavy, ask(trial, heavy), {expected, {}}, 0, "on a base with an inertia");
}

}  // namespace grader::h7
