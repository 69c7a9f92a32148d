// STAFF ONLY. Hidden cases of H7's spherical joints.
//
// Pass 1 is compared with the student's own revolute joints, which turn about the same axis at the same rate,
// so a mistake of all joints does not show. In passes 2 and 3 the joints first all hang from the base, with
// their centres of mass at the base's, so that nothing is shifted and no order matters. Then come chains and
// trees, whose mistakes are excused if hinges in place of their spherical joints show them, too. Bounds:
// those of each pass's own cases.
#include "reference/H7/answers.h"

namespace grader::h7 {
namespace {

Tree with_revolute_joints(const Tree& tree) {
  Tree same = tree;
  std::vector<double> rates, Q;
  for (std::size_t i = 1; i < tree.links.size(); ++i) {
    Link& link = same.links[i];
    const int first = std::exchange(link.first, static_cast<int>(rates.size()));
    Q.push_back(tree.Q[first]);
    if (link.joint == JointType::spherical) {
      const Vector3d w = tree.rates.segment<3>(first);
      link.joint = JointType::revolute;
      link.u = w.normalized();
      rates.push_back(w.norm());
    } else {
      rates.push_back(tree.rates[first]);
    }
  }
  same.rates = Eigen::Map<const VectorXd>(rates.data(), static_cast<Eigen::Index>(rates.size()));
  same.Q = Eigen::Map<const VectorXd>(Q.data(), static_cast<Eigen::Index>(Q.size()));
  return same;
}

// c^ lacks omega x w, and the part at the centre of mass that comes from it.
void expect_pass_1(Trial& trial, int links) {
  const Tree tree = random_tree(trial.random, {.links = links, .types = kSpherical});
  const Sizes sizes = sizes_of(tree);
  const Of answered = ask(trial, 1, tree).passes;
  Of revolute = ask(trial, 1, with_revolute_joints(tree)).passes;
  for (std::size_t i = 1; i < tree.links.size(); ++i) {
    const Link& link = tree.links[i];
    if (link.joint != JointType::spherical) continue;
    const Vector3d turned =
        revolute[link.parent].v.angular.cross(Vector3d(tree.rates.segment<3>(link.first)));
    revolute[i].c += {-turned, -turned.cross(link.d)};
  }
  expect_motions(trial, answered, revolute, &LinkPass::v, sizes.length, roundings(tree) * sizes.speed,
                 "the velocity of a link with a spherical joint");
  expect_motions(trial, answered, revolute, &LinkPass::c, sizes.length,
                 roundings(tree) * sizes.acceleration(), "c^ of a link with a spherical joint");
  expect_forces(trial, answered, revolute, 1, 1, roundings(tree) * (100 + sizes.turn * sizes.turn),
                "Z^ of a link with a spherical joint");
}

void expect_pass_2(Trial& trial, Tree tree, const Sizes& sizes, double force, const Units& units) {
  const Units back{1 / units.mass, 1 / units.length, 1 / units.time};
  Tree other = in_units(tree, units);
  other.passes = ask(trial, 2, other).passes;
  const Of answered = in_units(other, back).passes;
  reference_passes(tree, 2);
  expect_inertias(trial, answered, tree.passes, sizes.length, 1e-9 * sizes.mass,
                  "I^A beside spherical joints");
  expect_forces(trial, answered, tree.passes, sizes.length, 0, 1e-9 * force, "Z^A beside spherical joints");
  for (std::size_t i = 1; i < tree.links.size(); ++i)
    if (tree.links[i].joint == JointType::spherical)
      trial.expect_at_most((answered[i].gain - tree.passes[i].gain).norm(), 1e-7 * tree.passes[i].gain.norm(),
                           "the gain of a spherical joint",
                           {answered[i].gain.reshaped(), tree.passes[i].gain.reshaped(), 9});
}

// The largest error over its bound.
double pass_2_error(Trial& trial, Tree tree) {
  const Sizes sizes = sizes_of(tree);
  reference_passes(tree, 1);
  const double force = force_size(tree);
  const Of answered = ask(trial, 2, tree).passes;
  reference_passes(tree, 2);
  return (inertia_error(answered, tree.passes, sizes.length) / sizes.mass +
          force_error(answered, tree.passes, sizes.length, 0) / force) /
         1e-9;
}

double pass_3_error(Trial& trial, Tree tree) {
  const Sizes sizes = sizes_of(tree);
  reference_passes(tree, 2);
  const Answered answered = ask(trial, 3, tree);
  const VectorXd expected = reference_passes(tree, 3);
  const double size = accelerations_size(tree, sizes, expected);
  return ((answered.accelerations - expected).norm() +
          motion_error(answered.passes, tree.passes, &LinkPass::a, 1)) /
         (1e-8 * size);
}

void expect_shifted(Trial& trial, const Tree& tree) {
  for (const auto error_of : {pass_2_error, pass_3_error}) {
    double error = error_of(trial, tree);
    if (!(error <= 1))
      trial.ask_aside([&] {
        if (!(error_of(trial, with_revolute_joints(tree)) <= 1)) error = 0;
      });
    trial.expect_at_most(error, 1,
                         error_of == pass_2_error
                             ? "I^A or Z^A in a chain or tree with spherical joints"
                             : "an acceleration in a chain or tree with spherical joints");
  }
}

}  // namespace

void spherical_joints(Trial& trial) {
  for (int links : {1, 3, 6, 10}) expect_pass_1(trial, links);
  for (int links : {1, 3, 6})
    for (const bool stiffens : {false, true}) {
      const Tree tree = random_tree(
          trial.random, {.links = links, .types = kSpherical, .form = Form::star, .stiffens = stiffens});
      const Sizes sizes = sizes_of(tree);
      Tree after_pass_1 = tree;
      reference_passes(after_pass_1, 1);
      const double force = force_size(after_pass_1);
      // Hair is light and short, with small stiffenings.
      for (const Units& units : {Units{}, Units{0x1p-60, 0x1p-30, 1}})
        expect_pass_2(trial, after_pass_1, sizes, force, units);
      trial.expect_at_most(pass_3_error(trial, tree), 1, "an acceleration beside spherical joints");
    }
  expect_shifted(trial, random_tree(trial.random, {.links = 3, .types = kSpherical}));
  expect_shifted(
      trial,
      random_tree(trial.random, {.links = 6, .types = kSpherical, .form = Form::branches, .stiffens = true}));
}

}  // namespace grader::h7
