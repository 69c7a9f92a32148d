// STAFF ONLY. H5 beyond its public checks: corrections in extremes.

#include "hair/length_correction.h"

#include <gtest/gtest.h>

#include "reference/H6/stepping_for_tests.h"

namespace reference_tests {
namespace {

using hair::CorrectionReport;
using hair::Strand;

Strand uniform(int segments) {
  return hair::uniform_strand({}, segments, 0.3);
}

// n numbers between -1 and 1 without a pattern: with them Newton's method gives up where a test says so.
VectorXd scattered_vector(Eigen::Index n, unsigned which) {
  VectorXd values(n);
  unsigned state = 2654435761u * (which + 1);
  for (double& value : values) {
    state = 1664525u * state + 1013904223u;
    value = state / 2147483648.0 - 1;
  }
  return values;
}

// A strand with its rest lengths, each segment turned against the one before by about `bend`.
VectorXd bent(const Strand& strand, double bend) {
  const VectorXd numbers = scattered_vector(3 * strand.count(), 0);
  VectorXd x = VectorXd::Zero(3 * strand.count());
  Vector3d u(0, 0, -1);
  for (int i = 0; i < strand.segments(); ++i) {
    u = (u + bend * numbers.segment<3>(3 * i)).normalized();
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + strand.rest_length[i] * u;
  }
  return x;
}

// The same, with all particles but the root moved by up to `size` of a segment.
VectorXd disturbed(const Strand& strand, double bend, double size) {
  VectorXd x = bent(strand, bend);
  x.tail(x.size() - 3) += size * strand.rest_length[0] * scattered_vector(3 * strand.segments(), 100);
  return x;
}

CorrectionReport correct(const Strand& strand, VectorXd& x) {
  MatrixXd scratch = MatrixXd::Constant(x.size(), hair::kCorrectionScratch, NAN);
  return correct_lengths(strand, 1e-12, 100, x, scratch);
}

// sqrt(sum m |dx|^2)
double moved(const Strand& strand, const VectorXd& from, const VectorXd& to) {
  double sum = 0;
  for (int i = 0; i < strand.count(); ++i)
    sum += strand.mass[i] * (to - from).segment<3>(3 * i).squaredNorm();
  return std::sqrt(sum);
}

// In each state it ends with finite positions and the right lengths.
TEST(CorrectLengths, SurvivesExtremes) {
  for (int n : {1, 2, 10, 30, 100, 1000, 9999})
    for (double bend : {0.0, 0.1, 0.5, 3.0}) {
      Strand strand = uniform(n);
      strand.root_tangent = Vector3d(1, 0, 0);
      const double l0 = strand.rest_length[0];
      const VectorXd x = bent(strand, bend);
      const auto expect_right = [&](const char* what, const Strand& of, VectorXd state) {
        const Vector3d root = state.head<3>();
        const CorrectionReport report = correct(of, state);
        EXPECT_TRUE(report.converged) << what << ", " << n << " segments, bend " << bend;
        EXPECT_LE(report.iterations, 31) << what;
        EXPECT_LE(hair::largest_stretch(of, state),
                  std::max(1e-12, 0x1p-50 * state.cwiseAbs().maxCoeff() / l0))
            << what << ", " << n << " segments, bend " << bend;
        EXPECT_EQ(state.head<3>(), root) << what;
      };
      for (const Vector3d& flung : {Vector3d(0, 0, 1.5), Vector3d(1.5, 0, 0.2), Vector3d(0, 0, -1.5)}) {
        VectorXd state = x;
        state.head<3>() += flung;
        expect_right("a root that was flung five times the hair's length away", strand, state);
      }
      expect_right("compressed to 1 %", strand, 0.01 * x);
      expect_right("stretched a hundredfold", strand, 100 * x);
      expect_right("all particles in one place", strand, 0 * x);
      VectorXd folded = 0 * x;
      for (int i = 1; i <= n; i += 2) folded[3 * i] = 1.05 * l0;
      expect_right("folded at every joint", strand, folded);
      expect_right("crumpled", strand, l0 * scattered_vector(3 * n + 3, 9));
      Strand uneven = strand;
      for (int i = 1; i <= n; i += 2) uneven.mass[i] *= 1e6;
      expect_right("masses 1:1e6", uneven, disturbed(uneven, bend, 0.01));
      uneven = strand;
      uneven.mass[n] *= 1e6;
      expect_right("a tip that is 1e6 times as heavy", uneven, disturbed(uneven, bend, 0.01));
    }
}

// Full steps would turn segments so far that particles move ten times as far as necessary, or more.
TEST(CorrectLengths, MovesACompressedHairNotMuchFartherThanRelaxationDoes) {
  for (int n : {30, 100}) {
    const Strand strand = uniform(n);
    const VectorXd before = 0.01 * bent(strand, 0.1);
    VectorXd newton = before, relaxed = before;
    EXPECT_LE(correct(strand, newton).iterations, 6) << "no give-up";
    EXPECT_TRUE(relax_lengths(strand, 1e-10, 20000, relaxed).converged);
    EXPECT_LE(moved(strand, before, newton), 3 * moved(strand, before, relaxed)) << n << " segments";
  }
}

TEST(CorrectLengths, GivesUpNewtonsMethodWhereItGetsNowhere) {
  const Strand strand = uniform(1000);
  VectorXd x = 100 * bent(strand, 0.1);
  const CorrectionReport report = correct(strand, x);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.iterations, 20)
      << "it would take all 30 of Newton's steps with smaller and smaller parts of them";
}

TEST(CorrectVelocities, IsAccurateForLongStraightStrandsAndUnevenMasses) {
  Strand strand = uniform(9999);
  for (double ratio : {1.0, 1e6}) {
    for (int i = 1; i < strand.count(); i += 2) strand.mass[i] = ratio * strand.mass[2];
    const VectorXd x = bent(strand, 1e-3);
    VectorXd v = scattered_vector(30000, 5);
    MatrixXd scratch(x.size(), hair::kCorrectionScratch);
    EXPECT_TRUE(correct_velocities(strand, x, 1e-10, 100, v, scratch).converged);
    EXPECT_LE(largest_rate(strand, x, v), 1e-10);
    EXPECT_TRUE(v.allFinite());
  }
}

}  // namespace
}  // namespace reference_tests
