// STAFF ONLY. H5: hidden cases of correct_velocities, and of the masses in all three functions.
#include <Eigen/Geometry>

#include "reference/H5/answers.h"

namespace grader::h5 {
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
