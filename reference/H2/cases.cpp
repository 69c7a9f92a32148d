// STAFF ONLY. H2: hidden cases of bend_energy, add_bend_force and the two products. Bounds: joints.h.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "hair/angular_springs.h"
#include "reference/H2/joints.h"

namespace grader::h2 {
namespace {

using Eigen::Vector3d;

// Segments of 1 m with rest lengths of 1 m, since other categories have other lengths.
Posed some_pose(Random& random, int count, Range bend) {
  return random_pose(random, even_strand(random, count), {1, 1}, bend, "bent");
}

void expect_product_of(Trial& trial, const Posed& posed, int function) {
  const StrandForce force = strand_force();
  expect_product(trial, force, force.products[function - kProduct], posed,
                 random_vector(trial.random, posed.x.size()));
}

}  // namespace

void energy(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 10, 50}) expect_energy(trial, strand_force(), some_pose(random, count, kBend));
  expect_energy(trial, strand_force(), some_pose(random, 12, {0.02, 0.3}));
}

void forces(Trial& trial) {
  Random& random = trial.random;
  for (Range bend : {Range{0.1, 1}, Range{1, 1.5}, Range{1.6, 2.8}})
    for (int repeat = 0; repeat < 2; ++repeat)
      expect_force(trial, strand_force(), some_pose(random, 3, bend));
  for (int count : {4, 5, 20}) expect_force(trial, strand_force(), some_pose(random, count, kBend));
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 3, 4, 20}) expect_product_of(trial, some_pose(random, count, kBend), kProduct);
  expect_product_of(trial, some_pose(random, 10, {0.02, 0.3}), kProduct);
}

void spd_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 3, 4, 20}) {
    for (Range bend : {Range{0.1, 1.4}, Range{1.7, 2.8}}) {
      const Posed posed = some_pose(random, count, bend);
      expect_product_of(trial, posed, kSpdProduct);
      const VectorXd dx = random_vector(random, posed.x.size());
      trial.expect_at_most(dx.dot(ask_spd(trial, posed, dx)), product_rounding(posed, dx) * dx.lpNorm<1>(),
                           "dx . df, which for a semi-definite S is never positive,");
    }
  }
}

// The cases below compare the student's own answers, so that a mistake elsewhere does not count again.

void sampling(Trial& trial) {
  Random& random = trial.random;
  // The lecture's circle, in n segments of length 2 pi R / n, which meet at n - 1 joints.
  const double EI = random.uniform(2, 7), R = random.uniform(0.05, 0.4);
  std::vector<double> energies;
  for (int n : {8, 16, 32, 64}) {
    Strand strand = even_strand(random, n + 1);
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

  // One joint has different segments and always the same angle: each answer times l1 + l2 is the same.
  Posed joint = some_pose(random, 3, {0.5, 1});
  const VectorXd push = random_vector(random, 9), force = ask_force(trial, joint),
                 product = ask_product(trial, joint, push), semi_definite = ask_spd(trial, joint, push);
  energies.clear();
  for (auto [l1, l2] : {std::pair{1.0, 1.0}, {0.1, 0.3}, {0.4, 0.02}, {5.0, 2.0}}) {
    joint.strand.rest_length.setOnes();
    const double of_force = 2 * force_rounding(joint), of_product = 2 * product_rounding(joint, push);
    joint.strand.rest_length << l1, l2;
    const double l = (l1 + l2) / 2;
    energies.push_back(ask_energy(trial, joint) * (l1 + l2));
    expect_vector(trial, ask_force(trial, joint) * l, force, of_force, "the force with uneven rest lengths");
    for (const auto& [function, expected] : {std::pair{kProduct, &product}, {kSpdProduct, &semi_definite}})
      expect_vector(trial, ask_product(trial, joint, push, function) * l, *expected, of_product,
                    "the product with uneven rest lengths");
  }
  expect_all_equal(trial, energies, 4096 * kUnit,
                   "how a joint's energy times its segments' lengths changes with them");

  expect_own_rest_lengths(
      trial, strand_force(),
      random_pose(random, checks::ordinary_strand(random, 6), kStretch, {0.3, 1.4}, "uneven rest lengths"),
      3);

  // With rest lengths that are r times as long all answers are divided by r.
  Strand strand = even_strand(random, 6);
  strand.clamped = true;
  strand.root_tangent = checks::ordinary_direction(random);
  const Posed one = random_pose(random, strand, {1, 1}, {0.2, 1}, "rest lengths of 1 m");
  const VectorXd dx = random_vector(random, one.x.size()), f = ask_force(trial, one),
                 df = ask_product(trial, one, dx), spd = ask_spd(trial, one, dx);
  const double E = ask_energy(trial, one);
  for (double r : {8.0, 0x1p-10}) {
    Posed other = one;
    other.strand.rest_length *= r;
    other.name = "other rest lengths";
    trial.expect_at_most(std::abs(ask_energy(trial, other) * r - E), 2 * energy_rounding(one),
                         "the error of the energy with other rest lengths");
    expect_vector(trial, ask_force(trial, other) * r, f, 2 * force_rounding(one),
                  "the force with other rest lengths");
    expect_vector(trial, ask_product(trial, other, dx) * r, df, 2 * product_rounding(one, dx),
                  "the product with other rest lengths");
    expect_vector(trial, ask_spd(trial, other, dx) * r, spd, 2 * product_rounding(one, dx),
                  "the product with other rest lengths");
  }
}

namespace {

// The joint with current lengths of a and b, and the middle particle at 0.
Posed with_lengths(const Posed& joint, double a, double b) {
  const Vector3d middle = joint.x.segment<3>(3);
  Posed posed = joint;
  posed.x << a * (joint.x.head<3>() - middle), Vector3d::Zero(), b * (joint.x.tail<3>() - middle);
  posed.name = "one joint, lengths " + std::to_string(a) + " and " + std::to_string(b);
  return posed;
}

}  // namespace

// The energy depends on directions alone. So its derivatives by the two ends fall with the lengths that lead
// to them.
void current_lengths(Trial& trial) {
  Random& random = trial.random;
  for (auto [a, b] : {std::pair{0.6, 0.6}, {0.5, 3.0}, {2.5, 0.7}}) {
    const Posed one = with_lengths(some_pose(random, 3, {0.4, 1.4}), 1, 1), other = with_lengths(one, a, b);
    const double energy = ask_energy(trial, one);
    trial.expect_at_most(std::abs(ask_energy(trial, other) - energy), 2 * energy_rounding(one),
                         "the error of the energy with other lengths");
    // The ends of an answer are judged; the middle, too, if the answer for lengths of 1 m is balanced.
    const auto expect_scaled = [&](const VectorXd& answer, const VectorXd& of_one, double first, double last,
                                   double rounding, const std::string& what) {
      VectorXd expected = answer;
      expected.head<3>() = of_one.head<3>() * first;
      expected.tail<3>() = of_one.tail<3>() * last;
      if (is_balanced(of_one, rounding)) expected.segment<3>(3) = -(expected.head<3>() + expected.tail<3>());
      expect_vector(trial, answer, expected, 4 * rounding, what);
    };
    const VectorXd f = ask_force(trial, one);
    expect_not_zero(trial, f, "the force");
    expect_scaled(ask_force(trial, other), f, 1 / a, 1 / b, force_rounding(other),
                  "the force with other lengths");
    for (int function : {kProduct, kSpdProduct}) {
      for (int moved : {0, 2}) {
        const double own = moved == 0 ? a : b;
        VectorXd dx = VectorXd::Zero(9);
        dx.segment<3>(3 * moved) = random_vector(random, 3);
        const VectorXd df = ask_product(trial, one, dx, function);
        expect_not_zero(trial, df, "the product");
        expect_scaled(ask_product(trial, other, dx, function), df, 1 / (own * a), 1 / (own * b),
                      product_rounding(other, dx), "the product with other lengths");
      }
      // If a joint that moves as a whole does not change, the middle's part balances the two ends'.
      const VectorXd whole = random_vector(random, 3).replicate(3, 1);
      if (largest(ask_product(trial, one, whole, function)) <= product_rounding(one, whole))
        expect_vector(trial, ask_product(trial, other, whole, function), VectorXd::Zero(9),
                      product_rounding(other, whole),
                      "the product where all three particles move alike, with other lengths");
    }
  }
}

void added(Trial& trial) {
  expect_added(trial, strand_force(), some_pose(trial.random, 9, {0.2, 2}), 16);
}

namespace {

// All answers keep their proportions in any size, from the thinnest cobweb to steel as long as a galaxy.
void other_units(Trial& trial) {
  Random& random = trial.random;
  Strand strand = even_strand(random, 7);
  strand.clamped = true;
  strand.root_tangent = checks::ordinary_direction(random);
  const Posed one = random_pose(random, strand, {1, 1}, {0.3, 1.4}, "a strand"),
              other = random_pose(random, strand, {1, 1}, {0.3, 1.4}, "another");
  // The contract's limits are 1e-100 and 1e100 m: 2^-332 and 2^332.
  expect_same_in_other_units(trial, strand_force(), one, other, {0x1p-320, 0x1p-40, 0x1p320});
}

// In a zigzag of 10,001 particles with equal joints each end behaves like that of a strand of 5.
void long_strand(Trial& trial) {
  Random& random = trial.random;
  const Vector3d direction = checks::ordinary_direction(random), aside = checks::ordinary_direction(random),
                 push = random_vector(random, 3);
  const double bend = random.uniform(0.5, 1);
  const Strand few = even_strand(random, 5);
  Strand many = even_strand(random, 10001);
  many.bend_rigidity = few.bend_rigidity;
  const Posed brief = zigzag(few, direction, aside, bend), lengthy = zigzag(many, direction, aside, bend);
  // Coordinates round by u of the strand's length; products divide by the sine, of 0.47 at least, twice.
  const double rounding = 512 * kUnit * few.bend_rigidity * many.count();
  expect_ends_alike(trial, strand_force(), brief, lengthy, 2, rounding, push);
}

}  // namespace

void extremes(Trial& trial) {
  other_units(trial);
  long_strand(trial);
}

}  // namespace grader::h2
