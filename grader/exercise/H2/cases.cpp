// STAFF ONLY. H2: hidden cases of bend_energy, add_bend_force and the two products. Bounds: h2_joints.h.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "grader/exercise/H2/joints.h"
#include "grader/exercise/H2/limits.h"
#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"
#include "hair/angular_springs.h"

namespace grader::h2 {
namespace {

using Eigen::Vector3d;

void energy(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 10, 50})
    expect_energy(trial, random_pose(random, toy_strand(random, count), kStretch, kBend, "bent"));
  expect_energy(trial, random_pose(random, toy_strand(random, 12), {1, 1}, {0.02, 0.3}, "bent a little"));
}

void single_joint(Trial& trial) {
  Random& random = trial.random;
  for (Range bend : {Range{0.1, 1}, Range{1, 1.5}, Range{1.6, 2.8}})
    for (int repeat = 0; repeat < 2; ++repeat)
      expect_force(trial, random_pose(random, toy_strand(random, 3), kStretch, bend, "one joint"));
}

void strand_forces(Trial& trial) {
  Random& random = trial.random;
  for (int count : {4, 5, 20})
    expect_force(trial, random_pose(random, toy_strand(random, count), kStretch, kBend, "bent"));
  expect_force(trial,
               random_pose(random, toy_strand(random, 8), {0.01, 0.011}, {0.1, 1}, "compressed to 1 %"));
  expect_force(trial, random_pose(random, toy_strand(random, 10000), {1, 1}, {0.05, 0.3}, "long"));
}

void balance(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 6, 25}) {
    const Posed posed = random_pose(random, toy_strand(random, count), kStretch, kBend, "bent");
    const VectorXd f = ask_force(trial, posed);
    expect_size(trial, f.norm(), reference_force(posed).norm(), "the force");
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

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 3, 4, 20})
    expect_product(trial, random_pose(random, toy_strand(random, count), kStretch, kBend, "bent"), kProduct);
  expect_product(trial, random_pose(random, toy_strand(random, 10), kStretch, {0.02, 0.3}, "bent a little"),
                 kProduct);
}

void spd_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 3, 4, 20}) {
    for (Range bend : {Range{0.1, 1.4}, Range{1.7, 2.8}}) {
      const Posed posed = random_pose(random, toy_strand(random, count), kStretch, bend, "bent");
      expect_product(trial, posed, kSpdProduct);
      const VectorXd dx = random_vector(random, posed.x.size());
      trial.expect_at_most(dx.dot(ask_spd(trial, posed, dx)), product_rounding(posed, dx) * dx.lpNorm<1>(),
                           "dx . df, which for a semi-definite S is never positive,");
    }
  }
}

// Properties of the student's own answers: a mistake elsewhere does not count again.
void sampling(Trial& trial) {
  Random& random = trial.random;
  // The lecture's circle, in n segments of length 2 pi R / n, which meet at n - 1 joints.
  const double EI = random.uniform(2, 7), R = random.uniform(0.05, 0.4);
  std::vector<double> energies;
  for (int n : {8, 16, 32, 64}) {
    Strand strand = toy_strand(random, n + 1);
    strand.bend_rigidity = EI;
    strand.rest_length.setConstant(2 * std::numbers::pi * R / n);
    Posed circle{strand, VectorXd::Zero(3 * n + 3), "circle"};
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      circle.x.segment<3>(3 * i + 3) =
          circle.x.segment<3>(3 * i) + strand.rest_length[i] * Vector3d(std::cos(angle), 0, std::sin(angle));
    }
    energies.push_back(ask_energy(trial, circle) * n / (n - 1));
  }
  expect_size(trial, energies[0], std::numbers::pi * EI / R, "the energy");
  // Points of the circle round by u of its diameter, angles by u n: relative to themselves by u n^2.
  expect_all_equal(trial, energies, 16 * kUnit * 64 * 64,
                   "how the circle's energy changes with the number of segments");

  // One joint between segments that differ, at the same angle: E (l1 + l2) is the same.
  const Vector3d along(0, 0, -1), bent(0, std::sin(0.7), -std::cos(0.7));
  energies.clear();
  for (auto [l1, l2] : {std::pair{1.0, 1.0}, {0.1, 0.3}, {0.4, 0.02}, {5.0, 2.0}}) {
    Strand strand = toy_strand(random, 3);
    strand.bend_rigidity = EI;
    strand.rest_length << l1, l2;
    Posed posed{strand, VectorXd::Zero(9), "one joint"};
    posed.x.segment<3>(3) = l1 * along;
    posed.x.segment<3>(6) = l1 * along + l2 * bent;
    energies.push_back(ask_energy(trial, posed) * (l1 + l2));
  }
  expect_all_equal(trial, energies, 4096 * kUnit,
                   "how a joint's energy times its segments' lengths changes with them");

  // All lengths divided by r: E grows like r, f like r^2, products like r^3; down to hair of 1 mm a segment.
  const Posed large = random_pose(random, toy_strand(random, 6), {1, 1}, {0.2, 1}, "rest lengths of 1 m");
  const VectorXd dx = random_vector(random, large.x.size());
  const double E = ask_energy(trial, large);
  const VectorXd f = ask_force(trial, large), df = ask_product(trial, large, dx),
                 spd = ask_spd(trial, large, dx);
  expect_size(trial, f.norm(), reference_force(large).norm(), "the force");
  expect_size(trial, df.norm(), reference_product(large, dx, kProduct).norm(), "the product");
  expect_size(trial, spd.norm(), reference_product(large, dx, kSpdProduct).norm(), "the product");
  for (double r : {8.0, 1024.0}) {  // powers of two: nothing rounds differently
    Posed small = large;
    small.strand.rest_length /= r;
    small.x /= r;
    small.name = "scaled";
    auto expect = [&](const VectorXd& actual, const VectorXd& expected, const std::string& what) {
      expect_vector(trial, actual, expected, 1e-12 * largest(expected), what);
    };
    expect(VectorXd::Constant(1, ask_energy(trial, small)), VectorXd::Constant(1, E * r),
           "a short strand's energy");
    expect(ask_force(trial, small), f * r * r, "a short strand's force");
    expect(ask_product(trial, small, dx), df * r * r * r, "a short strand's product");
    expect(ask_spd(trial, small, dx), spd * r * r * r, "a short strand's product");
  }
}

void added(Trial& trial) {
  Random& random = trial.random;
  const Posed posed =
      random_pose(random, toy_strand(random, 9), kStretch, {0.2, 2}, "added to what is there");
  const VectorXd dx = random_vector(random, posed.x.size()), before = random_vector(random, posed.x.size());
  auto bound = [&](const VectorXd& of) { return 16 * kUnit * (largest(of) + largest(before)); };
  const VectorXd f = ask_force(trial, posed);
  expect_size(trial, f.norm(), reference_force(posed).norm(), "the force");
  expect_vector(trial, ask_force(trial, posed, before), f + before, bound(f) + force_rounding(posed),
                "the force that is added to what f held");
  for (int function : {kProduct, kSpdProduct}) {
    const VectorXd df = ask_product(trial, posed, dx, function);
    expect_size(trial, df.norm(), reference_product(posed, dx, function).norm(), "the product");
    expect_vector(trial, ask_product(trial, posed, dx, before, function), df + before,
                  bound(df) + product_rounding(posed, dx), "the product that is added to what df held");
  }
}

}  // namespace

WholeRunPoints whole_run() {
  return {2, 3};
}

std::vector<Category> categories() {
  return {{"Energy", "The energy", 2, energy},
          {"SingleJoint", "The force of a single joint", 3, single_joint},
          {"StrandForces", "The forces of a strand", 1, strand_forces},
          {"Balance", "Forces in balance", 2, balance},
          {"ClampedRoot", "The clamped root", 2, clamped_root},
          {"NearlyStraight", "Nearly straight", 2, nearly_straight},
          {"StraightProducts", "Products of a straight strand", 1, straight_products},
          {"LostDirections", "The fold, and particles in the same place", 2, lost_directions},
          {"ExactProduct", "The exact product", 3, exact_product},
          {"SpdProduct", "The semi-definite product", 3, spd_product},
          {"Sampling", "Lengths and sampling", 3, sampling},
          {"Added", "Added to what is there", 1, added}};
}

}  // namespace grader::h2
