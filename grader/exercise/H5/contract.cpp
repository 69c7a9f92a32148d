// STAFF ONLY. H5: hidden cases on what stays as it is, and on what is reported.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/exercise/H5/answers.h"
#include "grader/exercise/H5/cases.h"
#include "grader/suite/implicit_system.h"

namespace grader::h5 {

// To the last bit, and in motion.
void root(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 6}) {
    const Strand strand = random_strand(random, n, 3);
    const VectorXd right = placed(random, strand, 0.3), x = disturbed(random, right, 0.05);
    for (int function : {kRelax, kCorrect}) {
      trial.describe(name_of(function) + ", the root");
      const VectorXd after = correct(trial, function, strand, x, 1e-6, kMostSweeps).result;
      trial.expect(after.head<3>() == x.head<3>(), name_of(function) + " moves the root");
      trial.expect(after != x, name_of(function) + " does nothing");
    }
    trial.describe("correct_velocities, the root");
    const VectorXd v = random_vector(random, 3 * n);
    const VectorXd after = correct_velocities(trial, strand, right, v, 1e-6).result;
    trial.expect(after.head<3>() == v.head<3>(), "correct_velocities changes the root's velocity");
    trial.expect(after != v, "correct_velocities does nothing");
  }
}

namespace {

// What is within the tolerance is left alone, and what is not is not, however little it is.
void expect_tolerance_kept(Trial& trial, int function) {
  Random& random = trial.random;
  const std::string name = name_of(function);
  const Strand strand = random_strand(random, 8, 1);
  const VectorXd right = placed(random, strand, 0.3);
  const VectorXd nearly = disturbed(random, right, 1e-4);
  const Corrected left = correct(trial, function, strand, nearly, 2 * largest_error(strand, nearly), 100);
  trial.expect(left.result == nearly && left.report.iterations == 0 && left.report.converged,
               name + " works on a strand that is within its tolerance");
  for (double size : {4e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7}) {
    const VectorXd x = disturbed(random, right, size);
    const double error = largest_error(strand, x), tolerance = 1e-12,
                 round = rounding(x, strand.rest_length.minCoeff());
    if (error < 2 * (tolerance + round)) continue;
    const Corrected none = correct(trial, function, strand, x, tolerance, 0);
    trial.expect(!none.report.converged, name + " takes a larger error than its tolerance for converged");
    const Corrected all = correct(trial, function, strand, x, tolerance, kMostSweeps);
    trial.expect_at_most(largest_error(strand, all.result), tolerance + round,
                         "the largest error of a length after " + name);
  }
}

// An error that is the tolerance is not above it. A segment of 1.25 m in place of 1 m has the error 0.25, and one at 0.25 m/s is
// stretched at that velocity: without any rounding.
void expect_tolerance_inclusive(Trial& trial) {
  Strand strand = random_strand(trial.random, 2, 1);
  strand.rest_length[0] = 1;
  strand.root_tangent = Vector3d::UnitX();
  VectorXd x = VectorXd::Zero(6), v = VectorXd::Zero(6);
  x[3] = 1.25;
  v[3] = 0.25;
  trial.describe("an error that is the tolerance");
  for (int function : {kRelax, kCorrect}) {
    const Corrected left = correct(trial, function, strand, x, 0.25, 100);
    trial.expect(left.result == x && left.report.iterations == 0 && left.report.converged,
                 name_of(function) + " works on a strand that is within its tolerance");
  }
  const Corrected left = correct_velocities(trial, strand, x, v, 0.25);
  trial.expect(left.result == v && left.report.iterations == 0 && left.report.converged,
               "correct_velocities works on velocities that are within its tolerance");
}

// Numbers that are none are not converged; it ends.
void expect_numbers(Trial& trial) {
  Random& random = trial.random;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Strand strand = random_strand(random, 7, 1);
  const VectorXd right = placed(random, strand, 0.3);
  const Eigen::Index entry = 3 + random.integer(0, 17);
  VectorXd broken = right, v = VectorXd::Zero(right.size());
  broken[entry] = nan;
  trial.describe("a coordinate is not a number");
  for (int function : {kRelax, kCorrect})
    trial.expect(!correct(trial, function, strand, broken, 1e-6, 50).report.converged,
                 name_of(function) + " reports that it has converged where a coordinate is not a number");
  v[entry] = nan;
  trial.expect(!correct_velocities(trial, strand, right, v, 1e-6, 50).report.converged,
               "correct_velocities reports that it has converged where a velocity is not a number");
}

// A root that was flung away: what is reported is so. Where rounding alone leaves a thousandth and more, nothing is
// converged.
void expect_honest_when_flung(Trial& trial, int function) {
  Random& random = trial.random;
  for (double far : {1.0, 1e4, 1e16}) {
    const Strand strand = random_strand(random, 8, 1);
    VectorXd x = placed(random, strand, 0.3);
    x.head<3>() += far * Vector3d(random_vector(random, 3)).normalized();
    trial.describe(name_of(function) + ", the root flung away");
    const Corrected corrected = correct(trial, function, strand, x, 1e-10, 1000);
    trial.expect(corrected.result.allFinite(), name_of(function) + " gives coordinates that are not finite");
    const double error = largest_error(strand, corrected.result),
                 round = rounding(corrected.result, strand.rest_length.minCoeff());
    trial.expect(!corrected.report.converged || error <= 1e-10 + std::min(round, 2e-3),
                 name_of(function) + " reports that it has converged, and lengths are wrong",
                 std::to_string(error));
  }
}

void expect_velocity_report(Trial& trial) {
  Random& random = trial.random;
  trial.describe("correct_velocities, reports");
  const Strand strand = random_strand(random, 12, 1);
  const VectorXd x = placed(random, strand, 0.5);
  VectorXd still = VectorXd::Zero(x.size());
  const Vector3d turn = 100 * Vector3d(random_vector(random, 3)).normalized();
  for (int i = 1; i < strand.count(); ++i)
    still.segment<3>(3 * i) = turn.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>()));
  const double round = 64 * kUnit * strand.count() * still.cwiseAbs().maxCoeff();
  const Corrected nothing = correct_velocities(trial, strand, x, still, 1e-9);
  trial.expect(nothing.result == still && nothing.report.iterations == 0 && nothing.report.converged,
               "correct_velocities works on velocities that stretch nothing");

  // A tolerance in m/s, whatever the velocities are.
  const VectorXd slow = still + random_vector(random, x.size(), 1e-8);
  const Corrected little = correct_velocities(trial, strand, x, slow, 1e-9);
  trial.expect_at_most(largest_rate(strand, x, little.result), 1e-9 + round,
                       "the velocity at which a segment is still stretched");

  const VectorXd v = random_vector(random, x.size());
  const Corrected none = correct_velocities(trial, strand, x, v, 1e-9, 0);
  trial.expect(none.result == v && none.report.iterations == 0 && !none.report.converged,
               "correct_velocities does something when it may take no iterations");
  const Corrected all = correct_velocities(trial, strand, x, v, 1e-9);
  const int most = all.report.iterations;
  trial.require(all.report.converged && most > 0,
                "correct_velocities takes no iterations, or does not converge");
  const Corrected same = correct_velocities(trial, strand, x, v, 1e-9, most);
  trial.expect(same.result == all.result && same.report.iterations == most && same.report.converged,
               "correct_velocities does something else when it may take just the iterations that it needs");
  const Corrected fewer = correct_velocities(trial, strand, x, v, 1e-9, most - 1);
  trial.expect(!fewer.report.converged && fewer.report.iterations == most - 1,
               "correct_velocities needs fewer iterations than it reports", std::to_string(most));
}

// Newton's method halves the digits that are wrong, and all impulses at once are right at once; sweeps along 200 segments
// are hundreds. What is between them solves for other impulses.
void expect_few_or_sweeps(Trial& trial) {
  Random& random = trial.random;
  const Strand strand = random_strand(random, 201, 3);
  const VectorXd right = placed(random, strand, 0.05), x = disturbed(random, right, 0.005);
  trial.describe("correct_lengths, a hair of 200 segments");
  const int lengths = correct(trial, kCorrect, strand, x, 1e-10, kMostSweeps).report.iterations;
  trial.expect(lengths <= 8 || lengths >= 100,
               "correct_lengths takes more iterations than Newton's method, and fewer than sweeps",
               std::to_string(lengths));
  trial.describe("correct_velocities, a hair of 200 segments");
  const int velocities =
      correct_velocities(trial, strand, right, random_vector(random, right.size()), 1e-9).report.iterations;
  trial.expect(
      velocities <= 4 || velocities >= 100,
      "correct_velocities takes more iterations than for all impulses at once, and fewer than sweeps",
      std::to_string(velocities));
}

// Where one step is exact. With a mass of the root's in W the error of each would be w_0 / (w_0 + w_1) of the one before: lengths come out
// right, in hundreds of iterations if the strand is long, as by sweeps.
void expect_one_segment_at_once(Trial& trial) {
  Random& random = trial.random;
  const Strand pair = random_strand(random, 2, 3);
  const VectorXd right = placed(random, pair, 0);
  trial.describe("correct_lengths, one segment");
  const int lengths =
      correct(trial, kCorrect, pair, disturbed(random, right, 0.05), 1e-9, kMostSweeps).report.iterations;
  trial.expect(lengths <= 2, "correct_lengths takes more than two iterations for one segment",
               std::to_string(lengths));
  trial.describe("correct_velocities, one segment");
  const int velocities =
      correct_velocities(trial, pair, right, random_vector(random, right.size()), 1e-9).report.iterations;
  trial.expect(velocities <= 2, "correct_velocities takes more than two iterations for one segment",
               std::to_string(velocities));
}

}  // namespace

// The report is true: of the x that came back, of whether it is good enough, of how many iterations it took.
void report(Trial& trial) {
  Random& random = trial.random;
  for (int function : {kRelax, kCorrect}) {
    const std::string name = name_of(function);
    trial.describe(name + ", reports");
    const Strand strand = random_strand(random, 12, 1);
    const VectorXd right = placed(random, strand, 0.3), x = disturbed(random, right, 0.05);
    const double round = rounding(x, strand.rest_length.minCoeff());

    const Corrected nothing = correct(trial, function, strand, right, 1e-9, 100);
    trial.expect(nothing.result == right && nothing.report.iterations == 0 && nothing.report.converged,
                 name + " works on a strand that is right");
    const Corrected none = correct(trial, function, strand, x, 1e-9, 0);
    trial.expect(none.result == x && none.report.iterations == 0 && !none.report.converged,
                 name + " does something when it may take no iterations");
    trial.expect_at_most(std::abs(none.report.error - largest_error(strand, x)), round,
                         "the error of the error that " + name + " reports");

    const Corrected all = correct(trial, function, strand, x, 1e-9, kMostSweeps);
    trial.require(all.report.converged && all.report.iterations > 0,
                  name + " takes no iterations, or does not converge", std::to_string(all.report.iterations));
    expect_near(trial, function, strand, x, all.result);
    const int most = all.report.iterations;
    const Corrected same = correct(trial, function, strand, x, 1e-9, most);
    trial.expect(same.result == all.result && same.report.iterations == most,
                 name + " does something else when it may take just the iterations that it needs");
    const Corrected fewer = correct(trial, function, strand, x, 1e-9, most - 1);
    trial.expect(!fewer.report.converged && fewer.report.iterations == most - 1,
                 name + " needs fewer iterations than it reports", std::to_string(most));
    for (const Corrected& corrected : {all, fewer})
      trial.expect_at_most(std::abs(corrected.report.error - largest_error(strand, corrected.result)), round,
                           "the error of the error that " + name + " reports");
    expect_tolerance_kept(trial, function);
  }
  trial.describe("relax_lengths, one segment");
  const Strand pair = random_strand(random, 2, 3);
  const int sweeps =
      correct(trial, kRelax, pair, disturbed(random, placed(random, pair, 0), 0.05), 1e-9, kMostSweeps)
          .report.iterations;
  trial.expect(sweeps == 1, "relax_lengths takes more than one sweep to restore one segment's length",
               std::to_string(sweeps));
  expect_tolerance_inclusive(trial);
  expect_numbers(trial);
  expect_velocity_report(trial);
  expect_few_or_sweeps(trial);
  expect_one_segment_at_once(trial);
  for (int function : {kRelax, kCorrect}) expect_honest_when_flung(trial, function);
}

}  // namespace grader::h5
