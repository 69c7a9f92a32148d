// STAFF ONLY. H5: hidden cases on the root, on the report, and on the number of iterations.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/H5/answers.h"

namespace grader::h5 {
namespace {

// A strand whose root is as light as the others.
Strand with_light_root(Random& random, int n) {
  Strand strand = random_strand(random, n, 3);
  strand.mass[0] = random.uniform(0.4, 0.9) * strand.mass[1];
  return strand;
}

}  // namespace

// The root keeps its place and its velocity to the last bit. A few iterations show it. All segments are too
// long, since a segment with the right length by chance would need no correction.
void root(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 6}) {
    Strand strand = with_light_root(random, n);
    const VectorXd x = placed(random, strand, 0.3);
    strand.rest_length *= 0.999;
    for (int function : {kRelax, kCorrect}) {
      trial.describe(name_of(function) + ", the root");
      const VectorXd after = correct(trial, function, strand, x, 1e-6, 3).result;
      trial.expect(after.head<3>() == x.head<3>(), name_of(function) + " moves the root");
      trial.expect(after != x, name_of(function) + " does nothing");
    }
    trial.describe("correct_velocities, the root");
    const VectorXd v = random_vector(random, 3 * n);
    trial.expect(correct_velocities(trial, strand, x, v, 1e-6, 3).result.head<3>() == v.head<3>(),
                 "correct_velocities changes the root's velocity");
  }
}

namespace {

// A correction with its report, and the error that is really left.
struct Reported {
  const char* name;
  Corrected corrected;
  double error, round;  // the error of the result, and its rounding
};

// The report is true, even if the correction is wrong.
void expect_true(Trial& trial, const Reported& one, double tolerance, int most) {
  const CorrectionReport& report = one.corrected.report;
  const std::string name = one.name;
  trial.expect(report.iterations >= 0 && report.iterations <= most,
               name + " takes more iterations than it may", std::to_string(report.iterations));
  trial.expect_at_most(std::abs(report.error - one.error), one.round,
                       "the error of the error that " + name + " reports");
  if (std::abs(one.error - tolerance) > one.round)
    trial.expect(report.converged == (one.error <= tolerance),
                 name + " reports that it has converged, and it has not; or the other way round",
                 std::to_string(one.error));
}

// `ask(most)` asks for a correction of `before` with a tolerance that it does not meet yet.
template <class Ask>
void expect_true_reports(Trial& trial, const VectorXd& before, double tolerance, Ask&& ask) {
  const Reported none = ask(0), few = ask(3), all = ask(kMostSweeps);
  const std::string name = none.name;
  expect_true(trial, none, tolerance, 0);
  trial.expect(none.corrected.result == before, name + " does something when it may take no iterations");
  expect_true(trial, few, tolerance, 3);
  // A function that never converges has no number of iterations to check.
  if (!all.corrected.report.converged || all.corrected.report.iterations < 1) return;
  const int most = all.corrected.report.iterations;
  const Reported same = ask(most), fewer = ask(most - 1);
  trial.expect(same.corrected.result == all.corrected.result && same.corrected.report.iterations == most,
               name + " does something else when it may take just the iterations that it needs");
  trial.expect(!fewer.corrected.report.converged && fewer.corrected.report.iterations == most - 1,
               name + " needs fewer iterations than it reports", std::to_string(most));
  for (const Reported& one : {all, fewer}) expect_true(trial, one, tolerance, kMostSweeps);
}

void expect_left_alone(Trial& trial, const std::string& name, const VectorXd& before,
                       const Corrected& after) {
  trial.expect(after.result == before && after.report.iterations == 0 && after.report.converged,
               name + " works on what is within its tolerance");
}

// An error that equals the tolerance is not above it. A segment of 0.625 m in place of 0.5 m has the error
// 0.25, and the rate of another one is 0.25 m/s, both without any rounding.
void expect_tolerance_inclusive(Trial& trial) {
  Strand strand = random_strand(trial.random, 2, 1);
  strand.rest_length[0] = 0.5;
  strand.root_tangent = Vector3d::UnitX();
  VectorXd x = VectorXd::Zero(6), v = VectorXd::Zero(6);
  x[3] = 0.625;
  v[3] = 0.25;
  trial.describe("an error that is the tolerance");
  for (int function : {kRelax, kCorrect}) {
    expect_left_alone(trial, name_of(function), x, correct(trial, function, strand, x, 0.25, 100));
  }
  expect_left_alone(trial, "correct_velocities", v, correct_velocities(trial, strand, x, v, 0.25));
}

// With NaN or infinity the call ends, and is not converged.
void expect_numbers(Trial& trial) {
  Random& random = trial.random;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Strand strand = random_strand(random, 7, 3);
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

}  // namespace

void report(Trial& trial) {
  Random& random = trial.random;
  const Strand strand = random_strand(random, 12, 3);
  const double shortest = strand.rest_length.minCoeff();
  const VectorXd right = placed(random, strand, 0.3), x = disturbed(random, right, 0.05);
  for (int function : {kRelax, kCorrect}) {
    const std::string name = name_of(function);
    trial.describe(name + ", reports");
    expect_true_reports(trial, x, 1e-9, [&](int most) {
      const Corrected corrected = correct(trial, function, strand, x, 1e-9, most);
      const double round = rounding(corrected.result, shortest);
      return Reported{name.c_str(), corrected, largest_error(strand, corrected.result), round};
    });
    expect_left_alone(trial, name, right, correct(trial, function, strand, right, 1e-9, 100));
    const VectorXd nearly = disturbed(random, right, 1e-4);
    expect_left_alone(trial, name, nearly,
                      correct(trial, function, strand, nearly, 2 * largest_error(strand, nearly), 100));
    for (double size : {4e-12, 1e-10, 1e-8}) {
      const VectorXd wrong = disturbed(random, right, size);
      if (largest_error(strand, wrong) < 2 * (1e-12 + rounding(wrong, shortest))) continue;
      trial.expect(!correct(trial, function, strand, wrong, 1e-12, 0).report.converged,
                   name + " takes a larger error than its tolerance for converged");
    }
  }
  trial.describe("correct_velocities, reports");
  VectorXd still = VectorXd::Zero(x.size());
  const Vector3d turn = Vector3d(random_vector(random, 3)).normalized();
  for (int i = 1; i < strand.count(); ++i)
    still.segment<3>(3 * i) = turn.cross(Vector3d(right.segment<3>(3 * i) - right.head<3>()));
  expect_left_alone(trial, "correct_velocities", still,
                    correct_velocities(trial, strand, right, still, 1e-9));
  const VectorXd v = random_vector(random, x.size());
  expect_true_reports(trial, v, 1e-9, [&](int most) {
    const Corrected corrected = correct_velocities(trial, strand, right, v, 1e-9, most);
    const double round = 64 * kUnit * strand.count() * corrected.result.cwiseAbs().maxCoeff();
    return Reported{"correct_velocities", corrected, largest_rate(strand, right, corrected.result), round};
  });
  expect_tolerance_inclusive(trial);
  expect_numbers(trial);
}

// Newton's method doubles the right digits in each step, and all impulses at once need one step. Sweeps along
// 200 segments take hundreds. A number between these comes from wrong equations. One segment is right at
// once; if W had a mass for the root, each iteration would leave w_0 / (w_0 + w_1) of the error. A function
// that does not converge has no number.
void iterations(Trial& trial) {
  Random& random = trial.random;
  const auto expect_few = [&](const std::string& name, const Corrected& corrected, int few, int many) {
    const int taken = corrected.report.iterations;
    if (corrected.report.converged)
      trial.expect(taken <= few || taken >= many,
                   name + " takes more iterations than for all segments at once, and fewer than sweeps",
                   std::to_string(taken));
  };
  const Strand hair = random_strand(random, 201, 3);
  const VectorXd right = placed(random, hair, 0.05);
  trial.describe("a hair of 200 segments");
  expect_few("correct_lengths",
             correct(trial, kCorrect, hair, disturbed(random, right, 0.005), 1e-10, kMostSweeps), 8, 100);
  expect_few("correct_velocities",
             correct_velocities(trial, hair, right, random_vector(random, right.size()), 1e-9), 4, 100);

  Strand pair = with_light_root(random, 2);
  const VectorXd one = placed(random, pair, 0), x = disturbed(random, one, 0.05);
  trial.describe("one segment");
  expect_few("relax_lengths", correct(trial, kRelax, pair, x, 1e-9, kMostSweeps), 1, kMostSweeps);
  expect_few("correct_lengths", correct(trial, kCorrect, pair, x, 1e-9, kMostSweeps), 2, kMostSweeps);
  expect_few("correct_velocities", correct_velocities(trial, pair, one, random_vector(random, 6), 1e-9), 2,
             kMostSweeps);
}

}  // namespace grader::h5
