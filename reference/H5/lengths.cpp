// STAFF ONLY. H5: hidden cases of relax_lengths and correct_lengths, with strands of equal masses.
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

}  // namespace grader::h5
