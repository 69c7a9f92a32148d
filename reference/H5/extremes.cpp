// STAFF ONLY. H5: hidden cases of strands without directions, far from their lengths, in small units, and
// long.
#include <Eigen/Geometry>
#include <algorithm>

#include "reference/H5/answers.h"

namespace grader::h5 {
namespace {

// All segments were on one line through the root, in the direction u, so impulses along them keep particles
// there.
void expect_on_line(Trial& trial, int function, const Strand& strand, const Vector3d& u, const VectorXd& x) {
  trial.require(x.allFinite(), name_of(function) + " gives coordinates that are not finite");
  double farthest = 0;
  for (int i = 1; i < strand.count(); ++i)
    farthest = std::max(farthest, u.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>())).norm());
  trial.expect_at_most(farthest, 1e-4 * x.cwiseAbs().maxCoeff(),
                       "how far particles of a strand on a line are moved away from it");
}

// A straight strand that points along u, all distances from the root times `factor`.
VectorXd on_a_line(const Strand& strand, const Vector3d& root, const Vector3d& u, double factor) {
  VectorXd x(3 * strand.count());
  x.head<3>() = root;
  for (int i = 0; i < strand.segments(); ++i)
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + factor * strand.rest_length[i] * u;
  return x;
}

}  // namespace

// Folds, particles in the same place, a strand of one particle, one far too long or too short: checks only
// their special properties. Ten iterations show these.
void degenerate(Trial& trial) {
  Random& random = trial.random;
  constexpr int kFew = 10;
  Strand strand = random_strand(random, 6, 1);
  strand.root_tangent = Vector3d(random_vector(random, 3)).normalized();
  const Vector3d point = random_vector(random, 3), u = Vector3d(random_vector(random, 3)).normalized();
  Strand pair = random_strand(random, 2, 1);
  pair.root_tangent = strand.root_tangent;
  const Strand alone = random_strand(random, 1, 1);
  for (int function : {kRelax, kCorrect}) {
    trial.describe(name_of(function) + ", degenerate strands");
    const Corrected same = correct(trial, function, alone, point, 1e-9, kFew);
    trial.expect(same.result == point && same.report.converged && same.report.iterations == 0,
                 name_of(function) + " works on a strand of one particle");
    const auto on_line = [&](const Vector3d& direction, const VectorXd& x) {
      expect_on_line(trial, function, strand, direction,
                     correct(trial, function, strand, x, 1e-9, kFew).result);
    };
    // Segments have no direction here: the first one gets root_tangent's, the others that of the one before.
    on_line(strand.root_tangent, point.replicate(6, 1));
    VectorXd last = on_a_line(strand, point, u, 1.01);
    last.tail<3>() = last.segment<3>(12);
    on_line(u, last);
    const VectorXd drawn = correct(trial, function, pair, point.replicate(2, 1), 1e-9, kFew).result;
    trial.expect(pair.root_tangent.dot(drawn.tail<3>() - drawn.head<3>()) > 0,
                 "a segment of length 0 does not come out where root_tangent points");
    VectorXd folded = on_a_line(strand, point, u, 1);
    for (int i = 3; i < 6; ++i)
      folded.segment<3>(3 * i) = point + random.uniform(0.9, 1.1) * (i % 2) * (folded.segment<3>(9) - point);
    on_line(u, folded);
    for (double factor : {0.01, 3.0}) on_line(u, on_a_line(strand, point, u, factor));
  }
  trial.describe("correct_velocities, degenerate strands");
  const VectorXd v = random_vector(random, 6);
  const VectorXd after = correct_velocities(trial, pair, point.replicate(2, 1), v, 1e-9, kFew).result;
  trial.require(after.allFinite(), "correct_velocities gives velocities that are not finite");
  trial.expect_at_most(
      pair.root_tangent.cross(Vector3d((after - v).tail<3>())).norm(),
      1e-9 * (1 + v.norm()) + 1e-9 * (after - v).norm(),
      "how much the velocity across a segment of length 0, which points as root_tangent, changes");
}

// The report is true. If rounding alone leaves a thousandth and more, nothing is converged.
void far_root(Trial& trial) {
  Random& random = trial.random;
  for (double far : {1e2, 1e6, 2e13, 5e13, 1e14, 1e14, 1e18}) {
    const Strand strand = random_strand(random, 8, 1);
    VectorXd x = placed(random, strand, 0.3);
    x.head<3>() += far * Vector3d(random_vector(random, 3)).normalized();
    trial.describe("correct_lengths, the root flung away");
    const Corrected corrected = correct(trial, kCorrect, strand, x, 1e-10, 1000);
    // In the end rounding puts all other particles into one place: see `degenerate`.
    if (far < 1e18)
      trial.expect(corrected.result.allFinite(), "correct_lengths gives coordinates that are not finite");
    const double error = largest_error(strand, corrected.result),
                 round = rounding(corrected.result, strand.rest_length.minCoeff());
    trial.expect(!corrected.report.converged || error <= 2e-10 + std::min(round, 2e-3),
                 "correct_lengths reports that it has converged, and lengths are wrong",
                 std::to_string(error));
  }
}

// An error is relative to the rest length, and even the shortest segment has a direction. Powers of two
// change no rounding, so a few iterations are the same in each unit.
void units(Trial& trial) {
  Random& random = trial.random;
  Strand strand = random_strand(random, 8, 1);
  VectorXd x = placed(random, strand, 0.3);
  for (int i = 7; i >= 0; --i) x.segment<3>(3 * i) -= x.head<3>();
  x = disturbed(random, x, 0.05);
  for (int function : {kRelax, kCorrect}) {
    trial.describe(name_of(function) + ", in other units of length");
    const Corrected known = correct(trial, function, strand, x, 1e-8, 3);
    for (double unit : {0x1p-7, 0x1p-46}) {
      Strand other = strand;
      other.rest_length *= unit;
      const Corrected corrected = correct(trial, function, other, unit * x, 1e-8, 3);
      trial.expect(corrected.report.iterations == known.report.iterations,
                   name_of(function) + " takes other iterations in another unit of length",
                   std::to_string(corrected.report.iterations));
      trial.expect_close({corrected.result / unit, known.result}, 1e-9 * known.result.norm(),
                         "how much " + name_of(function) + "'s result changes in another unit of length");
    }
  }
}

// Each iteration must take linear time: one that builds full matrices runs out of time or memory. The strands
// are crumpled, so that few iterations are enough.
void long_strands(Trial& trial) {
  Random& random = trial.random;
  for (int n : {100, 1000, 10000}) {
    const Strand strand = random_strand(random, n, 1);
    const VectorXd x = disturbed(random, placed(random, strand, 3), 0.05);
    trial.describe(std::to_string(n) + " particles");
    for (int function : {kRelax, kCorrect})
      trial.expect(correct(trial, function, strand, x, 1e-8, 1000).report.iterations <= 1000,
                   name_of(function) + " takes more than 1000 iterations for a crumpled strand");
    trial.expect(
        correct_velocities(trial, strand, x, random_vector(random, 3 * n), 1e-8, 1000).report.iterations <=
            1000,
        "correct_velocities takes more than 1000 iterations for a crumpled strand");
  }
}

}  // namespace grader::h5
