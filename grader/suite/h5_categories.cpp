// STAFF ONLY. H5: hidden cases of relax_lengths, correct_lengths and correct_velocities. Sweeps may go in any order and
// methods differ, so that values are compared with the reference's only where all must agree:
//
//   - small errors: a correction is W J^T lambda with J at some state on the way. Where errors are of size e, all these
//     states differ by O(e), and so do corrections, relative to their size;
//   - velocities: what makes J v = 0 and is W J^T lambda is one and the same for all.
#include "grader/suite/h5_categories.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "grader/suite/implicit_system.h"
#include "grader/wire/strand_message.h"
#include "hair/length_correction.h"

namespace grader::h5 {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::CorrectionReport;
using hair::Strand;

constexpr double kUnit = 0x1p-53;
constexpr int kRelax = 0, kCorrect = 1, kVelocities = 2;  // as in serve_H5.cpp
constexpr double kFar = 5;                                // see expect_near
constexpr int kMostSweeps = 200000;                       // more than any case here needs

struct Corrected {
  VectorXd result;  // x or v
  CorrectionReport report;
};

Student::Products no_products() {
  return [](int, const auto&, auto&) -> bool { throw MalformedMessage("no operator"); };
}

CorrectionReport get_report(MessageReader& reply) {
  CorrectionReport report;
  report.iterations = reply.get<int>();
  report.error = reply.get<double>();
  report.converged = reply.get<std::uint8_t>() != 0;
  reply.expect_end();
  return report;
}

std::string name_of(int function) {
  return function == kRelax ? "relax_lengths" : "correct_lengths";
}

Corrected correct(Trial& trial, int function, const Strand& strand, const VectorXd& x, double tolerance,
                  int most) {
  MessageWriter message;
  message.put(function);
  put(message, strand);
  message.put(tolerance).put(most);
  put(message, x);
  MessageReader reply = trial.ask(message, no_products());
  Corrected corrected;
  corrected.result = get_vector(reply, x.size());
  corrected.report = get_report(reply);
  trial.expect(corrected.report.iterations >= 0 && corrected.report.iterations <= most,
               name_of(function) + " reports more iterations than it may take",
               std::to_string(corrected.report.iterations));
  return corrected;
}

Corrected correct_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                             double tolerance) {
  MessageWriter message;
  message.put(kVelocities);
  put(message, strand);
  message.put(tolerance).put(kMostSweeps);
  put(message, x);
  put(message, v);
  MessageReader reply = trial.ask(message, no_products());
  Corrected corrected;
  corrected.result = get_vector(reply, v.size());
  const VectorXd x_after = get_vector(reply, x.size());
  corrected.report = get_report(reply);
  trial.expect(x_after == x, "correct_velocities changes x");
  return corrected;
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

// n particles whose masses lie within a factor of `ratio`, segments of about 1 cm.
Strand random_strand(Random& random, int n, double ratio) {
  Strand strand;
  strand.mass.resize(n);
  strand.rest_length.resize(n - 1);
  const double unit = random.log_uniform(1e-7, 1e-3);
  for (double& mass : strand.mass) mass = unit * (ratio > 1 ? random.log_uniform(1, ratio) : 1);
  for (double& length : strand.rest_length) length = 0.01 * random.uniform(0.7, 1.4);
  return strand;
}

// At rest lengths, each segment turned against the one before by about `bend`.
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

// The same with every particle but the root off by about `size` of a segment.
VectorXd disturbed(Random& random, VectorXd x, double size) {
  x.tail(x.size() - 3) += random_vector(random, static_cast<int>(x.size()) - 3, 0.01 * size);
  return x;
}

// sqrt(sum m |dx|^2), what a correction has moved.
double moved(const Strand& strand, const VectorXd& from, const VectorXd& to) {
  double sum = 0;
  for (int i = 0; i < strand.count(); ++i)
    sum += strand.mass[i] * (to - from).segment<3>(3 * i).squaredNorm();
  return std::sqrt(sum);
}

VectorXd reference_lengths(const Strand& strand, VectorXd x) {
  MatrixXd scratch(x.size(), hair::kCorrectionScratch);
  hair::correct_lengths(strand, 1e-13, 100, x, scratch);
  return x;
}

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

// Rounding of a length beside a rest length: of the coordinates, of their differences and of the norm.
double rounding(const VectorXd& x, double length) {
  return 8 * kUnit * (x.cwiseAbs().maxCoeff() / length + 1);
}

void expect_lengths(Trial& trial, int function, const Strand& strand, double tolerance,
                    const Corrected& corrected) {
  const VectorXd& x = corrected.result;
  const double round = rounding(x, strand.segments() > 0 ? strand.rest_length.minCoeff() : 1);
  trial.expect_at_most(largest_error(strand, x), tolerance + round,
                       "the largest error of a length after " + name_of(function));
  trial.expect(corrected.report.converged, name_of(function) + " reports that it has not converged");
}

// Coarse: whatever the order of impulses along the segments, they add up to about what has to be moved, and
// even those that know no masses move a few times as much. What is put elsewhere is far beyond.
void expect_near(Trial& trial, int function, const Strand& strand, const VectorXd& x, const VectorXd& after) {
  trial.expect_at_most(moved(strand, x, after), kFar * moved(strand, x, reference_lengths(strand, x)),
                       "how far " + name_of(function) + " moves particles, by their masses");
}

void relaxation(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 8, 15}) {
    trial.describe("relax_lengths, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = disturbed(random, placed(random, strand, 0.3), 0.05);
    for (double tolerance : {1e-3, 1e-8}) {
      const Corrected corrected = correct(trial, kRelax, strand, x, tolerance, kMostSweeps);
      expect_lengths(trial, kRelax, strand, tolerance, corrected);
      expect_near(trial, kRelax, strand, x, corrected.result);
    }
  }
}

void lengths(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 10, 20}) {
    trial.describe("correct_lengths, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = disturbed(random, placed(random, strand, 0.3), 0.05);
    for (double tolerance : {1e-4, 1e-10}) {
      const Corrected corrected = correct(trial, kCorrect, strand, x, tolerance, kMostSweeps);
      expect_lengths(trial, kCorrect, strand, tolerance, corrected);
      expect_near(trial, kCorrect, strand, x, corrected.result);
    }
  }
}

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
    trial.expect(all.report.converged && all.report.iterations > 0,
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
  }
}

// Errors of 1e-5: corrections agree to a few of these, relative to their size. A segment turns by no more than what
// its ends move over its length, some 1e-4 where the errors of 12 segments add up.
void expect_small_correction(Trial& trial, int function, const Strand& strand) {
  Random& random = trial.random;
  const VectorXd x = disturbed(random, placed(random, strand, 0.4), 1e-5);
  const Corrected corrected = correct(trial, function, strand, x, 1e-12, kMostSweeps);
  const VectorXd expected = reference_lengths(strand, x);
  trial.expect_at_most(
      moved(strand, expected, corrected.result), 0.01 * moved(strand, x, expected),
      "how far " + name_of(function) + "'s particles are from where impulses along the segments move them");
}

void impulses(Trial& trial) {
  for (int n : {3, 5, 10}) {
    trial.describe("correct_lengths, equal masses, " + std::to_string(n) + " particles");
    expect_small_correction(trial, kCorrect, random_strand(trial.random, n, 1));
  }
}

void masses(Trial& trial) {
  for (int n : {3, 5, 10}) {
    trial.describe("correct_lengths, masses 1:10, " + std::to_string(n) + " particles");
    expect_small_correction(trial, kCorrect, random_strand(trial.random, n, 10));
  }
}

void relaxation_masses(Trial& trial) {
  for (double ratio : {1.0, 10.0})
    for (int n : {3, 5, 10}) {
      trial.describe("relax_lengths, masses 1:" + std::to_string(ratio) + ", " + std::to_string(n) +
                     " particles");
      expect_small_correction(trial, kRelax, random_strand(trial.random, n, ratio));
    }
}

// Errors of a few hundredths: every order of sweeps, and Newton's method, move particles by the same, within 2 %.
void distance(Trial& trial) {
  Random& random = trial.random;
  for (int n : {4, 8, 14}) {
    trial.describe("correct_lengths, distance, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = disturbed(random, placed(random, strand, 0.5), 0.02);
    const Corrected corrected = correct(trial, kCorrect, strand, x, 1e-9, kMostSweeps);
    const double ratio = moved(strand, x, corrected.result) / moved(strand, x, reference_lengths(strand, x));
    trial.expect_at_most(std::abs(ratio - 1), 0.02, "the difference from the distance that must be moved");
  }
}

// Anything, and a turn around the root, which stretches nothing and is many times as fast: it has to stay.
VectorXd turning(Random& random, const Strand& strand, const VectorXd& x) {
  VectorXd v = random_vector(random, 3 * strand.count());
  const Vector3d turn = 100 / strand.rest_length.sum() * Vector3d(random_vector(random, 3)).normalized();
  for (int i = 1; i < strand.count(); ++i)
    v.segment<3>(3 * i) += turn.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>()));
  return v;
}

// With `values`, beside the reference's: corrections differ by what the tolerance leaves, r of size tolerance in each
// segment, which is sqrt(r' (J W J')^-1 r) in the norm of `moved`.
void expect_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                       double tolerance, bool values) {
  const Corrected corrected = correct_velocities(trial, strand, x, v, tolerance);
  const double speed = v.cwiseAbs().maxCoeff(), round = 32 * kUnit * strand.count() * speed;
  trial.expect_at_most(largest_rate(strand, x, corrected.result), tolerance + round,
                       "the velocity at which a segment is still stretched");
  trial.expect(corrected.report.converged, "correct_velocities reports that it has not converged");
  trial.expect_at_most(std::abs(corrected.report.error - largest_rate(strand, x, corrected.result)), round,
                       "the error of the error that correct_velocities reports");
  VectorXd expected = v;
  MatrixXd scratch(v.size(), hair::kCorrectionScratch);
  hair::correct_velocities(strand, x, 1e-14 * speed, 10, expected, scratch);
  trial.expect_at_most(moved(strand, v, corrected.result), kFar * moved(strand, v, expected),
                       "how much correct_velocities changes velocities, by the masses");
  if (!values) return;

  const double smallest =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(multiplier_matrix(strand, x), Eigen::EigenvaluesOnly)
          .eigenvalues()
          .minCoeff();
  const double left = (tolerance + round) * std::sqrt(strand.segments());
  trial.expect_at_most(moved(strand, expected, corrected.result), 2 * left / std::sqrt(smallest),
                       "how far velocities are from what impulses along the segments make of them");
}

void velocities(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 8, 15}) {
    trial.describe("correct_velocities, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = placed(random, strand, 0.5), v = turning(random, strand, x);
    for (double tolerance : {1e-3, 1e-9}) expect_velocities(trial, strand, x, v, tolerance, false);
  }
}

void velocity_impulses(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 8, 15}) {
    trial.describe("correct_velocities, masses 1:10, " + std::to_string(n) + " particles");
    const Strand strand = random_strand(random, n, 10);
    const VectorXd x = placed(random, strand, 0.5), v = random_vector(random, 3 * n);
    expect_velocities(trial, strand, x, v, 1e-9, true);
  }
}

// All segments lay along one line through the root, in the direction u: impulses along them leave particles there.
void expect_on_line(Trial& trial, const Strand& strand, const Vector3d& u, const VectorXd& x) {
  double farthest = 0;
  for (int i = 1; i < strand.count(); ++i)
    farthest = std::max(farthest, u.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>())).norm());
  trial.expect_at_most(farthest, 1e-4 * strand.rest_length.minCoeff(),
                       "how far particles of a strand on a line are moved away from it");
}

// Folds, particles in the same place, a strand of one particle, one far too long or too short.
void degenerate(Trial& trial) {
  Random& random = trial.random;
  for (int function : {kRelax, kCorrect}) {
    trial.describe(name_of(function) + ", degenerate strands");
    const Strand alone = random_strand(random, 1, 1);
    const VectorXd point = random_vector(random, 3);
    expect_lengths(trial, function, alone, 1e-9, correct(trial, function, alone, point, 1e-9, 100));

    Strand strand = random_strand(random, 6, 1);
    strand.root_tangent = Vector3d(random_vector(random, 3)).normalized();
    // Without a direction: the first segment gets root_tangent's, the others that of the one before, whichever that
    // is when their turn comes.
    const VectorXd together = point.replicate(6, 1);
    expect_lengths(trial, function, strand, 1e-9,
                   correct(trial, function, strand, together, 1e-9, kMostSweeps));
    Strand pair = random_strand(random, 2, 1);
    pair.root_tangent = strand.root_tangent;
    const Corrected drawn = correct(trial, function, pair, point.replicate(2, 1), 1e-9, kMostSweeps);
    trial.expect_at_most((drawn.result.tail<3>() - point - pair.rest_length[0] * pair.root_tangent).norm(),
                         1e-8,
                         "how far the tip of a segment of length 0 comes out from where root_tangent points");

    VectorXd folded = placed(random, strand, 0);
    const Vector3d out = folded.segment<3>(9) - folded.head<3>();
    for (int i = 3; i < 6; ++i)
      folded.segment<3>(3 * i) = folded.head<3>() + random.uniform(0.9, 1.1) * (i % 2) * out / 3;
    const Corrected unfolded = correct(trial, function, strand, folded, 1e-9, kMostSweeps);
    expect_lengths(trial, function, strand, 1e-9, unfolded);
    expect_on_line(trial, strand, out.normalized(), unfolded.result);

    for (double factor : {0.01, 3.0}) {
      VectorXd x = placed(random, strand, 0);
      for (int i = 1; i < 6; ++i)
        x.segment<3>(3 * i) = x.head<3>() + factor * (x.segment<3>(3 * i) - x.head<3>());
      expect_lengths(trial, function, strand, 1e-9, correct(trial, function, strand, x, 1e-9, kMostSweeps));
    }
  }
  trial.describe("correct_velocities, a strand of one particle");
  expect_velocities(trial, random_strand(random, 1, 1), random_vector(random, 3), random_vector(random, 3),
                    1e-9, false);
}

// A long strand that is crumpled takes few iterations, of either method, and each has to take linear time: one that
// builds full matrices is out of time or memory.
void long_strands(Trial& trial) {
  Random& random = trial.random;
  for (int n : {100, 1000, 10000}) {
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = disturbed(random, placed(random, strand, 3), 0.05);
    for (int function : {kRelax, kCorrect}) {
      trial.describe(name_of(function) + ", " + std::to_string(n) + " particles");
      const Corrected corrected = correct(trial, function, strand, x, 1e-8, 1000);
      expect_lengths(trial, function, strand, 1e-8, corrected);
      expect_near(trial, function, strand, x, corrected.result);
    }
    trial.describe("correct_velocities, " + std::to_string(n) + " particles");
    expect_velocities(trial, strand, x, random_vector(random, 3 * n), 1e-8, false);
  }
}

}  // namespace

std::vector<Category> categories() {
  return {{"Relaxation", "Relaxation of lengths", 2, relaxation},
          {"RelaxationMasses", "Relaxation by masses", 2, relaxation_masses},
          {"Lengths", "Lengths, corrected", 2, lengths},
          {"Impulses", "Impulses along the segments", 2, impulses},
          {"Masses", "Masses", 1, masses},
          {"Distance", "The distance moved", 1, distance},
          {"Root", "The root", 2, root},
          {"Report", "The report", 2, report},
          {"Velocities", "Velocities", 2, velocities},
          {"VelocityImpulses", "Impulses on velocities", 2, velocity_impulses},
          {"Degenerate", "Folds, points and single particles", 1, degenerate},
          {"LongStrands", "Long strands", 1, long_strands}};
}

}  // namespace grader::h5
