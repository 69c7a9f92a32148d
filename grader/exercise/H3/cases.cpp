// STAFF ONLY. H3: hidden cases of bend_spring_energy, add_bend_spring_force and add_bend_spring_product.
//
// Rounding: as of H1's springs (H1/categories.cpp), and for an entry where two springs meet 128 u = 2^-46 of
//
//   k (d + d0)  N,     k (1 + d0/d) |de|  N,     k |d - d0| (d + d0)  N m,
//
// and for the energy 4 u k (d + d0)^2 more, since it may be written k (d^2 - 2 d d0 + d0^2) / 2.
#include <Eigen/Geometry>
#include <cmath>

#include "grader/exercise/H3/calls.h"
#include "grader/suite/strand_trial.h"
#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"
#include "hair/bend_springs.h"

namespace grader::h3 {
namespace {

using Eigen::Vector3d;

double ask_energy(Trial& trial, const Posed& posed) {
  return energy_of<Calls, hair::bend_spring_energy>(trial, posed);
}

VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
  return sum_of<Calls, hair::add_bend_spring_force>(trial, posed, "a force", before);
}

VectorXd ask_force(Trial& trial, const Posed& posed) {
  return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term = GeometricTerm::full) {
  return sum_of<Calls, hair::add_bend_spring_product>(trial, posed, "a product", before, term, dx);
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx,
                     GeometricTerm term = GeometricTerm::full) {
  return ask_product(trial, posed, dx, VectorXd::Zero(dx.size()), term);
}

constexpr Range kStretch = {0.6, 1.5}, kLong = {2, 3}, kBend = {0.1, 2.2};

struct Spring {
  double stiffness, rest, distance;
};

Spring spring(const Posed& posed, int i) {
  const double rest = posed.strand.rest_length[i] + posed.strand.rest_length[i + 1];
  return {posed.strand.skip_rigidity / rest, rest,
          (posed.x.segment<3>(3 * i + 6) - posed.x.segment<3>(3 * i)).norm()};
}

void expect_energy(Trial& trial, const Posed& posed) {
  const double expected = hair::bend_spring_energy(posed.strand, posed.x);
  double rounding = kUnit * posed.strand.count() * expected;
  for (int i = 0; i + 2 < posed.strand.count(); ++i) {
    const auto [k, d0, d] = spring(posed, i);
    rounding += 64 * kUnit * k * (std::abs(d - d0) + 64 * kUnit * d0) * (d + d0);
    rounding += 4 * kUnit * k * (d + d0) * (d + d0);
  }
  trial.expect_at_most(std::abs(ask_energy(trial, posed) - expected), rounding, "the error of the energy");
}

VectorXd reference_force(const Posed& posed) {
  VectorXd f = VectorXd::Zero(posed.x.size());
  hair::add_bend_spring_force(posed.strand, posed.x, f);
  return f;
}

double force_rounding(const Posed& posed) {
  double most = 0;
  for (int i = 0; i + 2 < posed.strand.count(); ++i) {
    const auto [k, d0, d] = spring(posed, i);
    most = std::max(most, k * (d + d0));
  }
  return 128 * kUnit * most;
}

void expect_force(Trial& trial, const Posed& posed) {
  expect_vector(trial, ask_force(trial, posed), reference_force(posed), force_rounding(posed), "the force");
}

double product_rounding(const Posed& posed, const VectorXd& dx) {
  double most = 0;
  for (int i = 0; i + 2 < posed.strand.count(); ++i) {
    const auto [k, d0, d] = spring(posed, i);
    if (d > 0) most = std::max(most, k * (1 + d0 / d));
  }
  return 128 * kUnit * most * 4 * largest(dx);
}

VectorXd reference_product(const Posed& posed, const VectorXd& dx, GeometricTerm term) {
  VectorXd df = VectorXd::Zero(dx.size());
  hair::add_bend_spring_product(posed.strand, posed.x, term, dx, df);
  return df;
}

void expect_product(Trial& trial, const Posed& posed, GeometricTerm term) {
  const VectorXd dx = random_vector(trial.random, posed.x.size());
  expect_vector(trial, ask_product(trial, posed, dx, term), reference_product(posed, dx, term),
                product_rounding(posed, dx), "the product");
}

// Springs whose rest length is 1 m: what k is made of is another category's.
Strand half_metres(Random& random, int count) {
  Strand strand = toy_strand(random, count);
  strand.rest_length.setConstant(0.5);
  return strand;
}

// Springs in compression, in tension, and both.
std::vector<Posed> states(Random& random, int count) {
  return {random_pose(random, half_metres(random, count), kStretch, kBend, "bent"),
          random_pose(random, half_metres(random, count), kLong, {0.1, 0.6}, "stretched"),
          random_pose(random, half_metres(random, count), {1, 1}, {0.01, 0.2}, "bent a little")};
}

void energy(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 12, 40})
    for (const Posed& posed : states(random, count)) expect_energy(trial, posed);
}

void single_spring(Trial& trial) {
  for (int repeat = 0; repeat < 3; ++repeat)
    for (const Posed& posed : states(trial.random, 3)) expect_force(trial, posed);
}

void strand_forces(Trial& trial) {
  Random& random = trial.random;
  for (int count : {4, 5, 20})
    for (const Posed& posed : states(random, count)) expect_force(trial, posed);
  expect_force(trial, random_pose(random, half_metres(random, 10000), kStretch, {0, 1}, "long"));
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 15})
    for (const Posed& posed : states(random, count)) expect_product(trial, posed, GeometricTerm::full);
}

void filtered_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 15}) {
    for (const Posed& posed : states(random, count)) {
      for (GeometricTerm term : {GeometricTerm::filtered, GeometricTerm::dropped}) {
        expect_product(trial, posed, term);
        const VectorXd dx = random_vector(random, posed.x.size());
        trial.expect_at_most(
            dx.dot(ask_product(trial, posed, dx, term)), product_rounding(posed, dx) * dx.lpNorm<1>(),
            "dx . (df/dx) dx, which without the negative part of the geometric term is never positive,");
      }
    }
  }
}

// Properties of the student's own answers: a mistake elsewhere does not count again.
void lengths(Trial& trial) {
  Random& random = trial.random;
  const Posed large = random_pose(random, toy_strand(random, 6), {1.2, 1.6}, {0.2, 1}, "rest lengths of 1 m");
  const VectorXd dx = random_vector(random, large.x.size());
  const double E = ask_energy(trial, large);
  const VectorXd f = ask_force(trial, large), df = ask_product(trial, large, dx);
  expect_size(trial, E, hair::bend_spring_energy(large.strand, large.x), "the energy");
  expect_size(trial, f.norm(), reference_force(large).norm(), "the force");
  expect_size(trial, df.norm(), reference_product(large, dx, GeometricTerm::full).norm(), "the product");
  // All lengths divided by r, the rigidity as it was: E falls like 1/r, f stays, products grow like r.
  for (double r : {8.0, 1024.0}) {  // powers of two: nothing rounds differently
    Posed small = large;
    small.strand.rest_length /= r;
    small.x /= r;
    small.name = "scaled";
    auto expect = [&](const VectorXd& actual, const VectorXd& expected, const std::string& what) {
      expect_vector(trial, actual, expected, 1e-12 * largest(expected), what);
    };
    expect(VectorXd::Constant(1, ask_energy(trial, small)), VectorXd::Constant(1, E / r),
           "a short strand's energy");
    expect(ask_force(trial, small), f, "a short strand's force");
    expect(ask_product(trial, small, dx), df * r, "a short strand's product");
  }
  // Two segments that differ count by their sum: what one is longer the other may be shorter.
  std::vector<double> energies;
  for (double l1 : {1.0, 0.3, 1.7}) {
    Posed posed = random_pose(random, toy_strand(random, 3), {1, 1}, {0.3, 0.3}, "uneven");
    posed.strand = toy_strand(random, 3);
    posed.strand.skip_rigidity = large.strand.skip_rigidity;
    posed.strand.rest_length << l1, 2 - l1;
    posed.x.tail<3>() = posed.x.head<3>() + 2.5 * Vector3d::UnitX();
    energies.push_back(ask_energy(trial, posed));
  }
  expect_all_equal(trial, energies, 4096 * kUnit,
                   "how a spring's energy changes with how its rest length is divided");
}

void added(Trial& trial) {
  Random& random = trial.random;
  const Posed posed =
      random_pose(random, half_metres(random, 9), kStretch, {0.2, 2}, "added to what is there");
  const VectorXd dx = random_vector(random, posed.x.size()), before = random_vector(random, posed.x.size());
  auto bound = [&](const VectorXd& of) { return 8 * kUnit * (largest(of) + largest(before)); };
  const VectorXd f = ask_force(trial, posed), df = ask_product(trial, posed, dx);
  expect_size(trial, f.norm(), reference_force(posed).norm(), "the force");
  expect_size(trial, df.norm(), reference_product(posed, dx, GeometricTerm::full).norm(), "the product");
  expect_vector(trial, ask_force(trial, posed, before), f + before, bound(f) + force_rounding(posed),
                "the force that is added to what f held");
  expect_vector(trial, ask_product(trial, posed, dx, before), df + before,
                bound(df) + product_rounding(posed, dx), "the product that is added to what df held");
}

void no_direction(Trial& trial) {
  Random& random = trial.random;
  for (int count : {1, 2}) {
    const Posed posed{toy_strand(random, count), random_vector(random, 3 * count), "too short"};
    const VectorXd dx = random_vector(random, 3 * count);
    trial.expect(ask_energy(trial, posed) == 0, "a strand of fewer than 3 particles has an energy");
    trial.expect(ask_force(trial, posed).isZero(0), "a strand of fewer than 3 particles has a force");
    trial.expect(ask_product(trial, posed, dx).isZero(0), "a strand of fewer than 3 particles has a product");
  }
  // Particles i and i + 2 in the same place: folded; and all of them. What the others give is another
  // category's.
  for (int which : {0, 3, -1}) {
    Posed posed = random_pose(random, half_metres(random, 6), kStretch, kBend, "coincident particles");
    for (int i = 0; i < 6; ++i)
      if (which < 0 || i == which + 2)
        posed.x.segment<3>(3 * i) = posed.x.segment<3>(which < 0 ? 0 : 3 * which);
    const bool nothing = which < 0;
    trial.expect(ask_energy(trial, posed) > 0, "the energy of particles in the same place is not positive");
    const VectorXd f = ask_force(trial, posed), change = random_vector(random, posed.x.size());
    trial.expect(f.isZero(0) == nothing, "particles in the same place have a force, or others have none");
    for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
      trial.expect(ask_product(trial, posed, change, term).isZero(0) == nothing,
                   "particles in the same place have a product, or others have none");
  }
}

}  // namespace

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"Energy", "The energy", 1, energy},
          {"SingleSpring", "The force of a single spring", 2, single_spring},
          {"StrandForces", "The forces of a strand", 1, strand_forces},
          {"ExactProduct", "The exact product", 2, exact_product},
          {"FilteredProduct", "The geometric term, filtered and dropped", 1, filtered_product},
          {"Lengths", "Lengths", 1, lengths},
          {"Added", "Added to what is there", 1, added},
          {"NoDirection", "Particles in the same place, and too few", 1, no_direction}};
}

}  // namespace grader::h3
