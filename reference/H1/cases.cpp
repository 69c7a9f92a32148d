// STAFF ONLY. H1: hidden cases of stretch_energy, add_stretch_force and add_stretch_product. Bounds: springs.h.
#include <cmath>

#include "grader/judge/trial.h"
#include "hair/stretch_springs.h"
#include "reference/H1/springs.h"

namespace grader::h1 {
namespace {

using Eigen::Vector3d;

// Strands of `count` particles, stretched, compressed and both.
std::vector<Posed> states(Random& random, int count) {
  return {random_pose(random, toy_strand(random, count), kStretched, kAnyBend, "stretched"),
          random_pose(random, toy_strand(random, count), kCompressed, kAnyBend, "compressed"),
          random_pose(random, toy_strand(random, count), kToOnePercent, kAnyBend, "compressed to 1 %"),
          random_pose(random, toy_strand(random, count), kMixed, kAnyBend, "stretched and compressed")};
}

// At rest: lengths are right to the last bit.
Posed at_rest(Random& random, int count) {
  const Strand strand = toy_strand(random, count);
  return straight_pose(strand, strand.rest_length, Vector3d::UnitY(), "at rest");
}

}  // namespace

void energy(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 8, 40})
    for (const Posed& posed : states(random, count)) Stretch::expect_energy(trial, posed);
  Stretch::expect_energy(trial, at_rest(random, 6));
}

void forces(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 2, 2, 3, 4, 12, 60})
    for (const Posed& posed : states(random, count)) Stretch::expect_force(trial, posed);
  Stretch::expect_force(trial, at_rest(random, 6));
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 20})
    for (const Posed& posed : states(random, count))
      Stretch::expect_product(trial, posed, random_vector(random, posed.x.size()));
  const Posed rest = at_rest(random, 6);
  Stretch::expect_product(trial, rest, random_vector(random, rest.x.size()));
}

// Beside the student's own exact product, which is another category's.
void filtered_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 20}) {
    const VectorXd dx = random_vector(random, 3 * count);
    const Posed longer = random_pose(random, toy_strand(random, count), kStretched, kAnyBend, "stretched"),
                shorter = random_pose(random, toy_strand(random, count), kCompressed, kAnyBend, "compressed");
    expect_filtered(trial, Stretch::kProduct, longer, shorter, dx);
    const Vector3d direction = random_direction(random);
    VectorXd lengths(count - 1);
    for (double& one : lengths) one = random.uniform(kMixed.low, kMixed.high);
    expect_along_a_line(trial, Stretch::kProduct,
                        straight_pose(toy_strand(random, count), lengths, direction, "on a line"), direction,
                        dx);
  }
  expect_own_directions(trial, Stretch::kProduct,
                        random_pose(random, toy_strand(random, 6), kMixed, kAnyBend, "bent"), 1);
  for (int stretched : {0, 1}) {
    VectorXd lengths = VectorXd::Constant(2, 0.6);
    lengths[stretched] = 1.4;
    const Strand strand = toy_strand(random, 3);
    const Posed two = straight_pose(strand, lengths, random_direction(random), "one of both");
    for (int spring : {0, 1}) expect_own_term(trial, Stretch::kProduct, two, 2 * spring, spring == stretched);
  }
}

void sampling(Trial& trial) {
  Random& random = trial.random;
  // The same strand, at the same strain all along it, in 1, 2, 4 and 8 segments and in uneven ones.
  const Strand whole = toy_strand(random, 2);
  const double total = random.uniform(0.1, 0.4), strain = random.uniform(0.05, 0.3),
               EA = whole.stretch_rigidity;
  const Vector3d direction = random_direction(random);
  std::vector<double> energies;
  for (int segments : {1, 2, 4, 8, -5}) {
    Strand strand = toy_strand(random, std::abs(segments) + 1);
    strand.stretch_rigidity = EA;
    if (segments < 0)
      for (double& l : strand.rest_length) l = random.uniform(0.2, 1);
    strand.rest_length *= total / strand.rest_length.sum();
    energies.push_back(Stretch::ask_energy(
        trial, straight_pose(strand, (1 + strain) * strand.rest_length, direction, "divided")));
  }
  expect_size(trial, energies[0], EA * strain * strain * total / 2, "the energy");
  // strain is known to about 4 u of a length, relative to itself to 4 u / strain. Multiplied out, either energy is off by
  // another 4 u k (l + l0)^2, relative to k (l - l0)^2 / 2.
  const double multiplied_out = 16 * kUnit * std::pow((2 + strain) / strain, 2);
  expect_all_equal(trial, energies, 128 * kUnit / strain + multiplied_out,
                   "how the energy changes with the number of segments");

  // One segment, short or long: at the same strain the same force, and products as 1/l0.
  std::vector<double> forces, products;
  const VectorXd dx = random_vector(random, 6);
  for (double l0 : {total, total / 2, total / 7, 3 * total}) {
    Strand strand = whole;
    strand.rest_length[0] = l0;
    const Posed posed =
        straight_pose(strand, VectorXd::Constant(1, (1 + strain) * l0), direction, "one segment");
    forces.push_back(Stretch::ask_force(trial, posed).norm());
    products.push_back(Stretch::ask_product(trial, posed, dx).norm() * l0);
  }
  expect_size(trial, forces[0], EA * strain, "the force");
  expect_all_equal(trial, forces, 128 * kUnit / strain,
                   "how the force at a strain changes with a segment's length");
  expect_own_rest_lengths(
      trial, Stretch::strand_force(),
      random_pose(random, toy_strand(random, 6), {1.2, 1.5}, kAnyBend, "uneven rest lengths"), 2, "segments");
  expect_size(trial, products[0], EA * dx.norm(), "the product");
  expect_all_equal(trial, products, 256 * kUnit / strain,
                   "how the product times a segment's length changes with that length");
}

void added(Trial& trial) {
  expect_added(
      trial, Stretch::strand_force(),
      random_pose(trial.random, toy_strand(trial.random, 9), kMixed, kAnyBend, "added to what is there"), 8);
}

}  // namespace grader::h1
