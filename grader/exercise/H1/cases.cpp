// STAFF ONLY. H1: hidden cases of stretch_energy, add_stretch_force and add_stretch_product. Bounds: springs.h.
#include <cmath>

#include "grader/exercise/H1/limits.h"
#include "grader/exercise/H1/springs.h"
#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"
#include "hair/stretch_springs.h"

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

void energy(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 8, 40})
    for (const Posed& posed : states(random, count)) expect_energy(trial, posed);
  expect_energy(trial, at_rest(random, 6));
}

void forces(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 2, 2, 3, 4, 12, 60})
    for (const Posed& posed : states(random, count)) expect_force(trial, posed);
  expect_force(trial, at_rest(random, 6));
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 20})
    for (const Posed& posed : states(random, count)) expect_product(trial, posed, GeometricTerm::full);
  expect_product(trial, at_rest(random, 6), GeometricTerm::full);
}

// Beside the student's own exact product, which is another category's.
void filtered_product(Trial& trial) {
  Random& random = trial.random;
  const auto expect_same = [&](const Posed& posed, GeometricTerm term, const VectorXd& dx,
                               const VectorXd& expected, const std::string& what) {
    expect_vector(trial, ask_product(trial, posed, dx, term), expected, 2 * product_rounding(posed, dx),
                  what);
  };
  for (int count : {2, 3, 20}) {
    const VectorXd dx = random_vector(random, 3 * count);
    const Posed longer = random_pose(random, toy_strand(random, count), kStretched, kAnyBend, "stretched"),
                shorter = random_pose(random, toy_strand(random, count), kCompressed, kAnyBend, "compressed");
    const VectorXd full = ask_product(trial, longer, dx);
    expect_not_zero(trial, full, "the product");
    expect_same(longer, GeometricTerm::filtered, dx, full, "the filtered product of what is stretched");
    expect_same(shorter, GeometricTerm::filtered, dx, ask_product(trial, shorter, dx, GeometricTerm::dropped),
                "the filtered product of what is compressed");

    // On a line: no segment turns if all move along it, and without the geometric term nothing else has a force.
    const Vector3d direction = random_direction(random);
    VectorXd lengths(count - 1), along(3 * count);
    for (double& one : lengths) one = random.uniform(kMixed.low, kMixed.high);
    for (int i = 0; i < count; ++i) along.segment<3>(3 * i) = direction * direction.dot(dx.segment<3>(3 * i));
    const Posed line = straight_pose(toy_strand(random, count), lengths, direction, "on a line");
    const VectorXd full_along = ask_product(trial, line, along);
    for (GeometricTerm term : {GeometricTerm::filtered, GeometricTerm::dropped})
      expect_same(line, term, along, full_along, "the product along a line");
    expect_same(line, GeometricTerm::dropped, dx - along, VectorXd::Zero(dx.size()),
                "the product across a line, without the geometric term");
  }
  // In a bent strand, too, each segment has its own direction u: if its one end moves, what is left at the other one is the part along u.
  const Posed bent = random_pose(random, toy_strand(random, 6), kMixed, kAnyBend, "bent");
  for (int i = 0; i < bent.strand.segments(); ++i) {
    VectorXd dx = VectorXd::Zero(bent.x.size());
    dx.segment<3>(3 * i) = random_vector(random, 3);
    const Vector3d u = (bent.x.segment<3>(3 * i + 3) - bent.x.segment<3>(3 * i)).normalized(),
                   full = ask_product(trial, bent, dx).segment<3>(3 * i + 3);
    expect_vector(trial, ask_product(trial, bent, dx, GeometricTerm::dropped).segment<3>(3 * i + 3),
                  u * u.dot(full), 2 * product_rounding(bent, dx),
                  "the product of a bent strand, without the geometric term");
  }
  // Each segment for itself: one is stretched, and the other compressed.
  for (int stretched : {0, 1}) {
    VectorXd lengths = VectorXd::Constant(2, 0.6);
    lengths[stretched] = 1.4;
    const Posed posed =
        straight_pose(toy_strand(random, 3), lengths, random_direction(random), "one of both");
    for (int moved : {0, 1}) {  // its end alone
      VectorXd dx = VectorXd::Zero(9);
      dx.segment<3>(6 * moved) = random_vector(random, 3);
      const GeometricTerm same = moved == stretched ? GeometricTerm::full : GeometricTerm::dropped;
      expect_same(posed, GeometricTerm::filtered, dx, ask_product(trial, posed, dx, same),
                  "the filtered product of a strand with a stretched and a compressed segment");
    }
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
    energies.push_back(
        ask_energy(trial, straight_pose(strand, (1 + strain) * strand.rest_length, direction, "divided")));
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
    forces.push_back(ask_force(trial, posed).norm());
    products.push_back(ask_product(trial, posed, dx).norm() * l0);
  }
  expect_size(trial, forces[0], EA * strain, "the force");
  expect_all_equal(trial, forces, 128 * kUnit / strain,
                   "how the force at a strain changes with a segment's length");
  // Each segment has its own.
  Posed uneven = random_pose(random, toy_strand(random, 6), {1.2, 1.5}, kAnyBend, "uneven rest lengths");
  for (double& l : uneven.strand.rest_length) l = random.uniform(0.3, 2);
  const VectorXd change = random_vector(random, uneven.x.size());
  expect_sum_of_parts(
      trial, uneven, 2, 4 * force_rounding(uneven),
      [&](const Posed& posed, int) { return ask_force(trial, posed); },
      "the force on a strand with uneven rest lengths, beside those of its segments alone,");
  expect_sum_of_parts(
      trial, uneven, 2, 4 * product_rounding(uneven, change),
      [&](const Posed& posed, int first) {
        return ask_product(trial, posed, change.segment(3 * first, posed.x.size()));
      },
      "the product of a strand with uneven rest lengths, beside those of its segments alone,");
  expect_size(trial, products[0], EA * dx.norm(), "the product");
  expect_all_equal(trial, products, 256 * kUnit / strain,
                   "how the product times a segment's length changes with that length");
}

void added(Trial& trial) {
  Random& random = trial.random;
  const Posed posed = random_pose(random, toy_strand(random, 9), kMixed, kAnyBend, "added to what is there");
  const VectorXd dx = random_vector(random, posed.x.size()), before = random_vector(random, posed.x.size());
  // One more rounding of each sum, where each of two springs adds one.
  auto bound = [&](const VectorXd& of) { return 8 * kUnit * (largest(of) + largest(before)); };

  VectorXd expected = VectorXd::Zero(dx.size());
  hair::add_stretch_force(posed.strand, posed.x, expected);
  const VectorXd f = ask_force(trial, posed);
  expect_size(trial, f.norm(), expected.norm(), "the force");
  expect_vector(trial, ask_force(trial, posed, before), f + before, bound(f) + force_rounding(posed),
                "the force that is added to what f held");
  const VectorXd df = ask_product(trial, posed, dx);
  expect_size(trial, df.norm(), expected.norm(), "the product");
  expect_vector(trial, ask_product(trial, posed, dx, before), df + before,
                bound(df) + product_rounding(posed, dx), "the product that is added to what df held");
}

}  // namespace

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"Energy", "The energy", 2, energy},
          {"Forces", "The forces", 5, forces},
          {"ExactProduct", "The exact product", 3, exact_product},
          {"FilteredProduct", "The geometric term, filtered and dropped", 2, filtered_product},
          {"Sampling", "Lengths and sampling", 2, sampling},
          {"Added", "Added to what is there", 1, added},
          {"NoDirection", "Particles in the same place, and alone", 1, no_direction},
          {"Extremes", "Tiny, huge and long strands", 1, extremes}};
}

}  // namespace grader::h1
