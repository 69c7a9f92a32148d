// STAFF ONLY. H5: hidden cases of strands without directions, far from their lengths, and long.
#include <Eigen/Geometry>
#include <algorithm>

#include "grader/exercise/H5/answers.h"
#include "grader/exercise/H5/cases.h"
#include "grader/suite/implicit_system.h"

namespace grader::h5 {
namespace {

// All segments lay along one line through the root, in the direction u: impulses along them leave particles there.
void expect_on_line(Trial& trial, const Strand& strand, const Vector3d& u, const VectorXd& x) {
  double farthest = 0;
  for (int i = 1; i < strand.count(); ++i)
    farthest = std::max(farthest, u.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>())).norm());
  trial.expect_at_most(farthest, 1e-4 * strand.rest_length.minCoeff(),
                       "how far particles of a strand on a line are moved away from it");
}

}  // namespace

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

}  // namespace grader::h5
