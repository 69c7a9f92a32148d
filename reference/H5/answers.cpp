// STAFF ONLY. Draws strands and their states, asks for the calls of H5, and judges the answers.
#include "reference/H5/answers.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "grader/judge/cases/case_asker.h"
#include "handout/check/ordinary.h"
#include "reference/H5/calls.h"
#include "solver/dense_algebra.h"

namespace grader::h5 {
namespace {

using Eigen::MatrixXd;

constexpr double kFar = 5;  // see expect_near

// J W J^T, J = d(length)/dx with the root fixed.
MatrixXd multiplier_matrix(const Strand& strand, const VectorXd& x) {
  MatrixXd J = MatrixXd::Zero(strand.segments(), x.size());
  for (int i = 0; i < strand.segments(); ++i) {
    const Vector3d u = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).normalized();
    if (i > 0) J.block<1, 3>(i, 3 * i) = -u.transpose();
    J.block<1, 3>(i, 3 * i + 3) = u.transpose();
  }
  for (int i = 0; i < strand.count(); ++i) J.middleCols<3>(3 * i) /= std::sqrt(strand.mass[i]);
  return J * J.transpose();
}

}  // namespace

Strand random_strand(Random& random, int n, double ratio) {
  Strand strand;
  strand.mass.resize(n);
  const double unit = random.log_uniform(1e-7, 1e-3);
  for (double& mass : strand.mass) mass = unit * (ratio > 1 ? random.log_uniform(1, ratio) : 1);
  strand.mass[0] = 1e15 * unit;
  strand.rest_length = checks::ordinary_numbers(random, n - 1, 0.7, 1.4);
  return strand;
}

VectorXd placed(Random& random, const Strand& strand, double bend) {
  VectorXd x(3 * strand.count());
  x.head<3>() = random_vector(random, 3, 0.1);
  Vector3d u = Vector3d(random_vector(random, 3)).normalized();
  for (int i = 0; i < strand.segments(); ++i) {
    u = (u + bend * random_vector(random, 3)).normalized();
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + strand.rest_length[i] * u;
  }
  return x;
}

VectorXd disturbed(Random& random, VectorXd x, double size) {
  x.tail(x.size() - 3) += random_vector(random, x.size() - 3, size);
  return x;
}

double largest_error(const Strand& strand, const VectorXd& x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm(), l0 = strand.rest_length[i];
    const double error = std::abs(l - l0) / l0;
    if (!(error <= largest)) largest = error;
    if (std::isnan(largest)) break;
  }
  return largest;
}

double largest_rate(const Strand& strand, const VectorXd& x, const VectorXd& v) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Vector3d u = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).normalized();
    const double rate = std::abs(u.dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i)));
    if (!(rate <= largest)) largest = rate;
    if (std::isnan(largest)) break;
  }
  return largest;
}

double moved(const Strand& strand, const VectorXd& from, const VectorXd& to) {
  double sum = 0;
  for (int i = 1; i < strand.count(); ++i)
    sum += strand.mass[i] * (to - from).segment<3>(3 * i).squaredNorm();
  return std::sqrt(sum);
}

double rounding(const VectorXd& x, double length) {
  return 8 * kUnit * (x.cwiseAbs().maxCoeff() / length + 1);
}

std::string name_of(int function) {
  return function == kRelax ? "relax_lengths" : "correct_lengths";
}

Corrected correct(Trial& trial, int function, const Strand& strand, const VectorXd& x, double tolerance,
                  int most) {
  const auto [report, result] =
      function == kRelax
          ? answer_of<Calls, hair::relax_lengths>(trial, strand, tolerance, most, x)
          : answer_of<Calls, hair::correct_lengths>(trial, strand, tolerance, most, x, Filling{});
  return {result, report, x};
}

Corrected correct_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                             double tolerance, int most) {
  CaseAsker asker(trial);
  const auto [report, result] =
      answers<Calls, hair::correct_velocities>(asker, strand, x, tolerance, most, v, Filling{});
  trial.expect(!asker.changed_input(), "correct_velocities changes x");
  return {result, report, v};
}

VectorXd reference_lengths(const Strand& strand, VectorXd x) {
  MatrixXd scratch(x.size(), hair::kCorrectionScratch);
  hair::correct_lengths(strand, 1e-13, 100, x, scratch);
  return x;
}

Compared motions(const Corrected& corrected, const VectorXd& expected, double part) {
  const VectorXd motion = expected - corrected.before;
  return {corrected.result - corrected.before, motion, 3, {}, part * motion.lpNorm<Eigen::Infinity>()};
}

void expect_lengths(Trial& trial, int function, const Strand& strand, double tolerance,
                    const Corrected& corrected, double slack) {
  const VectorXd& x = corrected.result;
  const double round = rounding(x, strand.segments() > 0 ? strand.rest_length.minCoeff() : 1);
  // Each order of sweeps moves particles equally far, within 2 %.
  trial.expect_at_most(largest_error(strand, x), {tolerance, (slack - 1) * tolerance + round},
                       "the largest error of a length after " + name_of(function),
                       motions(corrected, reference_lengths(strand, corrected.before), 0.02));
  trial.expect(corrected.report.converged, name_of(function) + " reports that it has not converged");
}

void expect_near(Trial& trial, int function, const Strand& strand, const VectorXd& x, const VectorXd& after) {
  const double necessary = moved(strand, x, reference_lengths(strand, x));
  trial.expect_at_most(moved(strand, x, after), {necessary, (kFar - 1) * necessary},
                       "how far " + name_of(function) + " moves particles, by their masses");
}

void expect_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                       double tolerance) {
  const Corrected corrected = correct_velocities(trial, strand, x, v, tolerance);
  const double speed = v.cwiseAbs().maxCoeff(), round = 32 * kUnit * strand.count() * speed;
  VectorXd expected = v;
  MatrixXd scratch(v.size(), hair::kCorrectionScratch);
  hair::correct_velocities(strand, x, 1e-14 * speed, 10, expected, scratch);
  const Compared numbers = motions(corrected, expected, 1e-2);
  trial.expect_at_most(largest_rate(strand, x, corrected.result), {tolerance, round},
                       "the velocity at which a segment is still stretched", numbers);
  trial.expect(corrected.report.converged, "correct_velocities reports that it has not converged");
  if (strand.segments() == 0) return;

  const double smallest = solver::symmetric_eigenvalues(multiplier_matrix(strand, x)).minCoeff();
  const double of_rates = std::sqrt(strand.segments() / smallest);
  trial.expect_at_most(moved(strand, expected, corrected.result),
                       {of_rates * tolerance, of_rates * (tolerance + 2 * round)},
                       "how far velocities are from what impulses along the segments make of them", numbers);
}

}  // namespace grader::h5
