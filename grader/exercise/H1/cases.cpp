// STAFF ONLY. H1: hidden cases of stretch_energy, add_stretch_force and add_stretch_product.
//
// Rounding. A segment's vector comes out of one subtraction, so that its length l has a relative error of a
// few u = 2^-53, wherever the strand is. What is compared has gone through less than 16 more operations in
// either program, hence 64 u of
//
//   k (l + l0)              N        for a spring's force
//   k (1 + l0/l) |de|       N        for its product with a change de
//   k |l - l0| (l + l0)     N m      for its energy, and u for each term of the sum
//
// A right energy may also be written k (l^2 - 2 l l0 + l0^2) / 2. Its terms cancel near l0: two products, a difference
// and a sum round by u of at most (l + l0)^2 each, and l^2 may be known without the rounding of l, 4 u of it. That is
// at most 8 u (l + l0)^2 k / 2, hence another
//
//   4 u k (l + l0)^2        N m      for its energy
//
// and twice that for an entry, where two springs meet.
#include <cmath>

#include "grader/exercise/H1/calls.h"
#include "grader/suite/strand_trial.h"
#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"
#include "hair/stretch_springs.h"

namespace grader::h1 {
namespace {

using Eigen::Vector3d;

double ask_energy(Trial& trial, const Posed& posed) {
  return energy_of<Calls, hair::stretch_energy>(trial, posed);
}

VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
  return sum_of<Calls, hair::add_stretch_force>(trial, posed, "a force", before);
}

VectorXd ask_force(Trial& trial, const Posed& posed) {
  return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term = GeometricTerm::full) {
  return sum_of<Calls, hair::add_stretch_product>(trial, posed, "a product", before, term, dx);
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx,
                     GeometricTerm term = GeometricTerm::full) {
  return ask_product(trial, posed, dx, VectorXd::Zero(dx.size()), term);
}

double length(const Posed& posed, int i) {
  return (posed.x.segment<3>(3 * i + 3) - posed.x.segment<3>(3 * i)).norm();
}

double stiffness(const Strand& strand, int i) {
  return strand.stretch_rigidity / strand.rest_length[i];
}

void expect_energy(Trial& trial, const Posed& posed) {
  const double expected = hair::stretch_energy(posed.strand, posed.x);
  double rounding = kUnit * posed.strand.segments() * expected;
  for (int i = 0; i < posed.strand.segments(); ++i) {
    const double l = length(posed, i), l0 = posed.strand.rest_length[i];
    rounding += 64 * kUnit * stiffness(posed.strand, i) * (std::abs(l - l0) + 64 * kUnit * l0) * (l + l0);
    rounding += 4 * kUnit * stiffness(posed.strand, i) * (l + l0) * (l + l0);
  }
  trial.expect_at_most(std::abs(ask_energy(trial, posed) - expected), rounding, "the error of the energy");
}

double force_rounding(const Posed& posed) {
  double most = 0;
  for (int i = 0; i < posed.strand.segments(); ++i)
    most = std::max(most, stiffness(posed.strand, i) * (length(posed, i) + posed.strand.rest_length[i]));
  return 128 * kUnit * most;
}

void expect_force(Trial& trial, const Posed& posed) {
  VectorXd expected = VectorXd::Zero(posed.x.size());
  hair::add_stretch_force(posed.strand, posed.x, expected);
  expect_vector(trial, ask_force(trial, posed), expected, force_rounding(posed), "the force");
}

double product_rounding(const Posed& posed, const VectorXd& dx) {
  double most = 0;
  for (int i = 0; i < posed.strand.segments(); ++i) {
    const double l = length(posed, i);
    const Vector3d de = dx.segment<3>(3 * i + 3) - dx.segment<3>(3 * i);
    if (l > 0)
      most = std::max(most, stiffness(posed.strand, i) * (1 + posed.strand.rest_length[i] / l) * de.norm());
  }
  return 128 * kUnit * most;
}

void expect_product(Trial& trial, const Posed& posed, GeometricTerm term) {
  const VectorXd dx = random_vector(trial.random, posed.x.size());
  VectorXd expected = VectorXd::Zero(dx.size());
  hair::add_stretch_product(posed.strand, posed.x, term, dx, expected);
  expect_vector(trial, ask_product(trial, posed, dx, term), expected, product_rounding(posed, dx),
                "the product");
}

constexpr Range kStretched = {1.05, 1.8}, kCompressed = {0.3, 0.95}, kMixed = {0.5, 1.6},
                kAnyBend = {0.1, 2.8};

// Strands of `count` particles, stretched, compressed and both.
std::vector<Posed> states(Random& random, int count) {
  return {random_pose(random, toy_strand(random, count), kStretched, kAnyBend, "stretched"),
          random_pose(random, toy_strand(random, count), kCompressed, kAnyBend, "compressed"),
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

void single_spring(Trial& trial) {
  for (int repeat = 0; repeat < 3; ++repeat)
    for (const Posed& posed : states(trial.random, 2)) expect_force(trial, posed);
}

void strand_forces(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 12, 60})
    for (const Posed& posed : states(random, count)) expect_force(trial, posed);
  expect_force(trial, at_rest(random, 6));
}

void balance(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 5, 30}) {
    for (const Posed& posed : states(random, count)) {
      const VectorXd f = ask_force(trial, posed);
      VectorXd expected = VectorXd::Zero(f.size());
      hair::add_stretch_force(posed.strand, posed.x, expected);
      expect_size(trial, f.norm(), expected.norm(), "the force");
      Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
      for (int i = 0; i < count; ++i) {
        const Vector3d here = f.segment<3>(3 * i);
        sum += here;
        torque += Vector3d(posed.x.segment<3>(3 * i)).cross(here);
      }
      const double rounding = count * (force_rounding(posed) + kUnit * largest(f));
      trial.expect_at_most(sum.norm(), rounding, "the sum of all forces");
      trial.expect_at_most(torque.norm(), 2 * rounding * largest(posed.x), "the sum of all torques");
    }
  }
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 20})
    for (const Posed& posed : states(random, count)) expect_product(trial, posed, GeometricTerm::full);
  expect_product(trial, at_rest(random, 6), GeometricTerm::full);
}

void filtered_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {2, 3, 20}) {
    for (const Posed& posed : states(random, count)) {
      expect_product(trial, posed, GeometricTerm::filtered);
      expect_product(trial, posed, GeometricTerm::dropped);
      for (GeometricTerm term : {GeometricTerm::filtered, GeometricTerm::dropped}) {
        const VectorXd dx = random_vector(random, posed.x.size());
        const double work = dx.dot(ask_product(trial, posed, dx, term));
        trial.expect_at_most(
            work, product_rounding(posed, dx) * dx.lpNorm<1>(),
            "dx . (df/dx) dx, which without the negative part of the geometric term is never positive,");
      }
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

void no_direction(Trial& trial) {
  Random& random = trial.random;
  // A strand of one particle has no spring.
  const Posed lone{toy_strand(random, 1), random_vector(random, 3), "one particle"};
  const VectorXd dx = random_vector(random, 3);
  trial.expect(ask_energy(trial, lone) == 0, "a strand of one particle has an energy");
  trial.expect(ask_force(trial, lone).isZero(0), "a strand of one particle has a force");
  trial.expect(ask_product(trial, lone, dx).isZero(0), "a strand of one particle has a product");

  // Segments of length 0, at the root, the tip, in between, and everywhere. What the others give is another
  // category's.
  for (int which : {0, 2, 4, -1}) {
    Posed posed = random_pose(random, toy_strand(random, 6), kMixed, kAnyBend, "coincident particles");
    for (int i = 0; i < 5; ++i)
      if (i == which || which < 0) posed.x.segment<3>(3 * i + 3) = posed.x.segment<3>(3 * i);
    const bool nothing = which < 0;
    trial.expect(ask_energy(trial, posed) > 0, "the energy of segments of length 0 is not positive");
    const VectorXd f = ask_force(trial, posed), change = random_vector(random, posed.x.size());
    trial.expect(f.isZero(0) == nothing, "segments of length 0 have a force, or others have none");
    for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
      trial.expect(ask_product(trial, posed, change, term).isZero(0) == nothing,
                   "segments of length 0 have a product, or others have none");
  }
}

void extremes(Trial& trial) {
  Random& random = trial.random;
  // Real hair: 30 cm, a radius of 50 um, 3 GPa; and a million times as stiff.
  for (double stiffer : {1.0, 1e6}) {
    Strand hair = toy_strand(random, 31);
    hair.rest_length.setConstant(0.01);
    hair.mass.setConstant(1e-7);
    hair.stretch_rigidity = 23.56 * stiffer;
    for (const Posed& posed : {random_pose(random, hair, {0.999, 1.001}, {0, 0.2}, "real hair"),
                               random_pose(random, hair, {0.01, 0.012}, {0, 0.2}, "compressed to 1 %")}) {
      expect_energy(trial, posed);
      expect_force(trial, posed);
      expect_product(trial, posed, GeometricTerm::full);
      expect_product(trial, posed, GeometricTerm::filtered);
    }
  }
  const Posed lengthy = random_pose(random, toy_strand(random, 10000), kMixed, {0, 1}, "long");
  expect_energy(trial, lengthy);
  expect_force(trial, lengthy);
  expect_product(trial, lengthy, GeometricTerm::filtered);
}

}  // namespace

WholeRunPoints whole_run() {
  return {1, 3};
}

std::vector<Category> categories() {
  return {{"Energy", "The energy", 2, energy},
          {"SingleSpring", "The force of a single spring", 2, single_spring},
          {"StrandForces", "The forces of a strand", 1, strand_forces},
          {"Balance", "Forces in balance", 1, balance},
          {"ExactProduct", "The exact product", 2, exact_product},
          {"FilteredProduct", "The geometric term, filtered and dropped", 2, filtered_product},
          {"Sampling", "Lengths and sampling", 2, sampling},
          {"Added", "Added to what is there", 1, added},
          {"NoDirection", "Particles in the same place, and alone", 1, no_direction},
          {"Extremes", "Stiff, compressed and long strands", 1, extremes}};
}

}  // namespace grader::h1
