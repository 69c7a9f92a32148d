// STAFF ONLY. H5: hidden cases of relax_lengths and correct_lengths with strands of equal masses, of
// correct_velocities, and of the masses in all three functions.
#include <Eigen/Geometry>
#include <cmath>

#include "reference/H5/answers.h"

namespace grader::h5 {
namespace {

// With errors of 1e-5 corrections agree to a few 1e-5 of their size. A segment turns by no more than its
// ends' motion over its length, some 1e-4 where the errors of 12 segments add up.
void expect_small_correction(Trial& trial, int function, const Strand& strand) {
  Random& random = trial.random;
  const VectorXd x = disturbed(random, placed(random, strand, 0.4), 1e-5);
  const Corrected corrected = correct(trial, function, strand, x, 1e-12, kMostSweeps);
  const VectorXd expected = reference_lengths(strand, x);
  trial.expect_at_most(
      moved(strand, expected, corrected.result), 0.01 * moved(strand, x, expected),
      "how far " + name_of(function) + "'s particles are from where impulses along the segments move them",
      motions(corrected, expected, 0.01));
}

// Segments are 0.7 m and longer, so an error in metres that meets the tolerance is at most 1 / 0.7 of it, and
// passes here.
constexpr double kSlack = 1.5;

void expect_corrected(Trial& trial, int function, int n, double size, double tolerance) {
  Random& random = trial.random;
  trial.describe(name_of(function) + ", " + std::to_string(n) + " particles");
  const Strand strand = random_strand(random, n, 1);
  const VectorXd x = disturbed(random, placed(random, strand, 0.3), size);
  const Corrected corrected = correct(trial, function, strand, x, tolerance, kMostSweeps);
  expect_lengths(trial, function, strand, tolerance, corrected, kSlack);
  expect_near(trial, function, strand, x, corrected.result);
}

}  // namespace

void relaxation(Trial& trial) {
  for (int n : {2, 3, 8, 15}) {
    for (double tolerance : {1e-3, 1e-8}) expect_corrected(trial, kRelax, n, 0.05, tolerance);
    expect_corrected(trial, kRelax, n, 1e-8, 1e-12);
  }
  for (int n : {3, 5, 10}) {
    trial.describe("relax_lengths, equal masses, " + std::to_string(n) + " particles");
    expect_small_correction(trial, kRelax, random_strand(trial.random, n, 1));
  }
}

void lengths(Trial& trial) {
  for (int n : {2, 3, 10, 20}) {
    for (double tolerance : {1e-4, 1e-10}) expect_corrected(trial, kCorrect, n, 0.05, tolerance);
    expect_corrected(trial, kCorrect, n, 1e-8, 1e-12);
  }
}

void impulses(Trial& trial) {
  Random& random = trial.random;
  for (double ratio : {1.0, 10.0})
    for (int n : {3, 5, 10}) {
      trial.describe("correct_lengths, masses 1:" + std::to_string(ratio) + ", " + std::to_string(n) +
                     " particles");
      expect_small_correction(trial, kCorrect, random_strand(random, n, ratio));
    }
  // With errors of a few hundredths each order of sweeps, and Newton's method, move particles equally far,
  // within 2 %.
  for (int n : {4, 8, 14}) {
    trial.describe("correct_lengths, distance, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = disturbed(random, placed(random, strand, 0.5), 0.02);
    const Corrected corrected = correct(trial, kCorrect, strand, x, 1e-9, kMostSweeps);
    const double ratio = moved(strand, x, corrected.result) / moved(strand, x, reference_lengths(strand, x));
    trial.expect_at_most(std::abs(ratio - 1), 0.02, "the difference from the distance that must be moved");
  }
}

namespace {

// Random velocities plus a much faster turn around the root, which stretches nothing and so must stay.
VectorXd turning(Random& random, const Strand& strand, const VectorXd& x) {
  VectorXd v = random_vector(random, 3 * strand.count());
  const Vector3d turn = 100 / strand.rest_length.sum() * Vector3d(random_vector(random, 3)).normalized();
  for (int i = 1; i < strand.count(); ++i)
    v.segment<3>(3 * i) += turn.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>()));
  return v;
}

// Two segments at a right angle: an impulse along the second one does not stretch the first. So each method,
// even with a single sweep, only moves the two ends of the second segment by 1/mass.
struct Corner {
  Strand strand;
  VectorXd x;
  Vector3d along;        // the second segment
  double first, second;  // the parts of the two ends
};

Corner corner(Random& random) {
  Corner corner{random_strand(random, 3, 1), VectorXd(9), {}, 0, 0};
  corner.strand.mass[2] *= random.integer(0, 1) == 0 ? random.uniform(3, 10) : 1 / random.uniform(3, 10);
  const Vector3d u = Vector3d(random_vector(random, 3)).normalized();
  corner.along = u.cross(Vector3d(random_vector(random, 3))).normalized();
  corner.x.head<3>() = random_vector(random, 3, 0.1);
  corner.x.segment<3>(3) = corner.x.head<3>() + corner.strand.rest_length[0] * u;
  corner.x.tail<3>() = corner.x.segment<3>(3) + corner.strand.rest_length[1] * corner.along;
  const double m1 = corner.strand.mass[1], m2 = corner.strand.mass[2];
  corner.first = m2 / (m1 + m2);
  corner.second = m1 / (m1 + m2);
  return corner;
}

}  // namespace

void velocities(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 3, 8, 15}) {
    trial.describe("correct_velocities, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = placed(random, strand, 0.5), v = turning(random, strand, x);
    for (double tolerance : {1e-3, 1e-9}) expect_velocities(trial, strand, x, v, tolerance);
    expect_velocities(trial, strand, x, random_vector(random, 3 * n), 1e-9);
    // The tolerance is in m/s, for any velocities.
    expect_velocities(trial, strand, x, random_vector(random, 3 * n, 1e-8), 1e-9);
  }
}

void masses(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const Corner right = corner(random);
    const double wrong = (repeat % 2 == 0 ? 1e-6 : -1e-6) * right.strand.rest_length[1];
    VectorXd x = right.x, expected = right.x;
    x.tail<3>() += wrong * right.along;
    expected.segment<3>(3) += right.first * wrong * right.along;
    expected.tail<3>() += (1 - right.second) * wrong * right.along;
    for (int function : {kRelax, kCorrect}) {
      trial.describe(name_of(function) + ", masses at a right angle");
      const Corrected corrected = correct(trial, function, right.strand, x, 1e-10, kMostSweeps);
      trial.expect_at_most(
          (corrected.result - expected).norm(), 1e-9,
          "how far " + name_of(function) + "'s particles are from where their masses let them move",
          motions(corrected, expected, 1e-2));
    }
    trial.describe("correct_velocities, masses at a right angle");
    VectorXd v = VectorXd::Zero(9);
    const double speed = random.uniform(1, 2);
    v.tail<3>() = random_vector(random, 3);
    v.tail<3>() += (speed - right.along.dot(v.tail<3>())) * right.along;
    VectorXd after = v;
    after.segment<3>(3) += right.first * speed * right.along;
    after.tail<3>() -= right.second * speed * right.along;
    const Corrected corrected = correct_velocities(trial, right.strand, right.x, v, 1e-9);
    trial.expect_at_most((corrected.result - after).norm(), 1e-8,
                         "how far velocities are from what masses allow", motions(corrected, after, 1e-2));
  }
  for (int n : {3, 8, 15}) {
    trial.describe("correct_velocities, masses 1:10, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 10);
    const VectorXd x = placed(random, strand, 0.5);
    expect_velocities(trial, strand, x, random_vector(random, 3 * n), 1e-9);
  }
}

}  // namespace grader::h5
