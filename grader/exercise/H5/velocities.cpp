// STAFF ONLY. H5: hidden cases of correct_velocities.
#include <Eigen/Geometry>

#include "grader/exercise/H5/answers.h"
#include "grader/exercise/H5/cases.h"
#include "grader/suite/implicit_system.h"

namespace grader::h5 {
namespace {

// Anything, and a turn around the root, which stretches nothing and is many times as fast: it has to stay.
VectorXd turning(Random& random, const Strand& strand, const VectorXd& x) {
  VectorXd v = random_vector(random, 3 * strand.count());
  const Vector3d turn = 100 / strand.rest_length.sum() * Vector3d(random_vector(random, 3)).normalized();
  for (int i = 1; i < strand.count(); ++i)
    v.segment<3>(3 * i) += turn.cross(Vector3d(x.segment<3>(3 * i) - x.head<3>()));
  return v;
}

}  // namespace

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

}  // namespace grader::h5
