// The public checks of H5. Every failure prints the input, what was expected, what came, the error and its bound. The
// contract is in hair/length_correction.h.

#include "hair/length_correction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "check.h"
#include "derivative.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::CorrectionReport;
using hair::Strand;

namespace {

const double kU = std::ldexp(1.0, -53);

Strand strand_of(int count, double heaviest = 1) {
  Strand strand;
  strand.mass = VectorXd::LinSpaced(count, 1, heaviest);
  strand.rest_length = VectorXd::LinSpaced(count - 1, 1, 1.5);
  return strand;
}

// At rest lengths, bent, each particle but the root then off by up to `size`.
VectorXd bent(const Strand& strand, double size) {
  const VectorXd numbers = scattered_vector(6 * strand.count(), strand.count());
  VectorXd x = VectorXd::Zero(3 * strand.count());
  for (int i = 0; i < strand.segments(); ++i) {
    const Vector3d u = (Vector3d(0, 0, -1) + 0.5 * numbers.segment<3>(3 * i)).normalized();
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + strand.rest_length[i] * u;
  }
  x.tail(x.size() - 3) += size * numbers.tail(x.size() - 3);
  return x;
}

VectorXd vector(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

double largest_error(const Strand& strand, const VectorXd& x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    largest = std::max(largest, std::abs(l / strand.rest_length[i] - 1));
  }
  return largest;
}

// Either function, as a function of x.
using Correction = CorrectionReport (*)(const Strand&, double tolerance, int most, VectorXd& x);

CorrectionReport relax(const Strand& strand, double tolerance, int most, VectorXd& x) {
  return relax_lengths(strand, tolerance, most, x);
}

CorrectionReport correct(const Strand& strand, double tolerance, int most, VectorXd& x) {
  MatrixXd scratch = MatrixXd::Constant(x.size(), hair::kCorrectionScratch, 1e3);
  return correct_lengths(strand, tolerance, most, x, scratch);
}

void makes_lengths_right(Correction correction) {
  for (int count : {1, 2, 3, 10}) {
    const Strand strand = strand_of(count, 3);
    const VectorXd before = bent(strand, 0.05);
    VectorXd x = before;
    const CorrectionReport report = correction(strand, 1e-9, 100000, x);
    SCOPED_TRACE(std::to_string(count) + " particles, tolerance 1e-9, at x = " + particles_in_words(before));
    EXPECT_LE(largest_error(strand, x), 1e-9 + 64 * kU) << "the largest |l - l0| / l0 that is left";
    EXPECT_TRUE(report.converged);
    EXPECT_NEAR(report.error, largest_error(strand, x), 64 * kU) << "the error that is reported";
    EXPECT_EQ(x.head<3>(), before.head<3>()) << "the root moved";
    EXPECT_EQ(report.iterations > 0, largest_error(strand, before) > 1e-9) << report.iterations;
  }
}

void moves_by_masses(Correction correction) {
  // 2 m long at rest, 2.4 m now; the root at one end, then masses of 1 and 3 kg.
  Strand strand = strand_of(3);
  strand.mass = vector({1, 1, 3});
  strand.rest_length = vector({1, 1});
  VectorXd x = vector({0, 0, 0, 1, 0, 0, 2.4, 0, 0});
  correction(strand, 1e-12, 100000, x);
  expect_entries(x, vector({0, 0, 0, 1, 0, 0, 2, 0, 0}), 1e-11,
                 "a straight strand of 1 and 1.4 m, corrected to 1 and 1 m", "the tolerance, 1e-12, twice");
  // Only one segment is wrong, and not at the root: its ends move against each other by 1/mass, and the first then pulls
  // its own end back. For a small error e across a right angle the first segment does not see it.
  const double e = 1e-6;
  VectorXd corner = vector({0, 0, 0, 1, 0, 0, 1, 1 + e, 0});
  correction(strand, 1e-13, 100000, corner);
  expect_entries(corner - vector({0, 0, 0, 1, 0, 0, 1, 1, 0}),
                 vector({0, 0, 0, 0, 0.75 * e, 0, 0, 0.75 * e, 0}), 10 * e * e + 1e-12,
                 "the correction of a right angle whose second segment is 1e-6 too long, masses 1 and 3 kg",
                 "10 e^2 + 1e-12: second order, and the tolerance");
}

// A straight hair, its tip half as heavy as the other particles, that is 1 % too long.
int iterations_for(Correction correction, int segments) {
  Strand strand;
  strand.mass = VectorXd::Ones(segments + 1);
  strand.mass[segments] = 0.5;
  strand.rest_length = VectorXd::Constant(segments, 0.3 / segments);
  VectorXd x = VectorXd::Zero(3 * segments + 3);
  for (int i = 0; i <= segments; ++i) x[3 * i + 2] = -1.01 * 0.3 * i / segments;
  const CorrectionReport report = correction(strand, 1e-10, 1000000, x);
  EXPECT_TRUE(report.converged) << segments << " segments";
  return report.iterations;
}

}  // namespace

TEST(RelaxLengths, MakesLengthsRight) {
  makes_lengths_right(relax);
}

TEST(RelaxLengths, MovesByMasses) {
  moves_by_masses(relax);
}

TEST(RelaxLengths, EndsAfterTheSweepsThatItMayTake) {
  const Strand strand = strand_of(10);
  VectorXd x = bent(strand, 0.05);
  const CorrectionReport report = relax_lengths(strand, 1e-12, 3, x);
  EXPECT_EQ(report.iterations, 3) << "of 3 sweeps";
  EXPECT_FALSE(report.converged) << "3 sweeps don't make a strand of 10 particles right to 1e-12";
  EXPECT_NEAR(report.error, largest_error(strand, x), 64 * kU) << "the error of the x that is returned";
}

TEST(RelaxLengths, TakesSweepsThatGrowWithTheSquare) {
  std::printf(
      "A straight hair that is 1 %% too long, to 1e-10: your sweeps, for the table in the assignment\n");
  for (int segments : {10, 20, 30, 60})
    std::printf("  %3d segments  %6d\n", segments, iterations_for(relax, segments));
}

TEST(CorrectLengths, MakesLengthsRight) {
  makes_lengths_right(correct);
}

TEST(CorrectLengths, MovesByMasses) {
  moves_by_masses(correct);
}

TEST(CorrectLengths, TakesFewIterations) {
  std::printf("The same by correct_lengths: your iterations\n");
  for (int segments : {10, 20, 30, 60}) {
    const int iterations = iterations_for(correct, segments);
    std::printf("  %3d segments  %6d\n", segments, iterations);
    EXPECT_TRUE(iterations <= 8 || iterations >= 100)
        << iterations << " iterations for " << segments
        << " segments: Newton's method takes 8 at most, and sweeps take hundreds";
  }
  EXPECT_LE(iterations_for(correct, 1), 2) << "for one segment: the first step is exact. Has the root's mass "
                                              "a part in your matrix? 1/mass of it is 0";
}

TEST(CorrectLengths, GivesTheSameHoweverOftenItIsAsked) {
  const Strand strand = strand_of(5, 3);
  const VectorXd before = bent(strand, 0.05);
  VectorXd first = before;
  correct(strand, 1e-9, 1000, first);
  for (int i = 1; i <= kManyCalls; ++i) {
    VectorXd x = before;
    correct(strand, 1e-9, 1000, x);
    ASSERT_EQ(x, first) << "asked again for the same strand, " << i << " times so far";
  }
}

TEST(CorrectLengths, GivesASegmentOfNoLengthADirection) {
  Strand strand = strand_of(2);
  strand.rest_length[0] = 1;
  strand.root_tangent = Vector3d(0, 1, 0);
  VectorXd x = VectorXd::Zero(6);
  EXPECT_TRUE(correct(strand, 1e-9, 100000, x).converged);
  expect_entries(x, vector({0, 0, 0, 0, 1, 0}), 1e-8,
                 "two particles in one place, rest length 1 m, root_tangent (0, 1, 0)",
                 "ten times the tolerance");
  Strand longer = strand_of(4);
  VectorXd point = VectorXd::Ones(12);
  EXPECT_TRUE(correct(longer, 1e-9, 100000, point).converged) << "four particles in one place";
  EXPECT_LE(largest_error(longer, point), 1e-9 + 64 * kU) << "four particles in one place";
}

TEST(CorrectVelocities, StopStretching) {
  for (int count : {1, 2, 3, 10}) {
    const Strand strand = strand_of(count, 3);
    const VectorXd x = bent(strand, 0), before = scattered_vector(3 * count, 7);
    VectorXd v = before;
    MatrixXd scratch = MatrixXd::Constant(3 * count, hair::kCorrectionScratch, 1e3);
    const CorrectionReport report = correct_velocities(strand, x, 1e-9, 100000, v, scratch);
    SCOPED_TRACE(std::to_string(count) + " particles, tolerance 1e-9 m/s, at x = " + particles_in_words(x));
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(v.head<3>(), before.head<3>()) << "the root's velocity changed";
    for (int i = 0; i < count - 1; ++i) {
      const Vector3d u = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).normalized();
      EXPECT_LE(std::abs(u.dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i))), 1e-9 + 256 * kU)
          << "the rate at which segment " << i << " is stretched, m/s";
    }
  }
}

TEST(CorrectVelocities, OfOneSegmentAtOnce) {
  const Strand strand = strand_of(2, 3);
  VectorXd v = scattered_vector(6, 7);
  MatrixXd scratch(6, hair::kCorrectionScratch);
  EXPECT_LE(correct_velocities(strand, bent(strand, 0), 1e-9, 1000, v, scratch).iterations, 2)
      << "iterations for one segment: the first impulse is exact. 1/mass of the root is 0";
}

TEST(CorrectVelocities, ByEqualAndOppositeImpulses) {
  // A right angle: the first segment sees nothing of what the second needs, so that this is a collision of 1 and 3 kg.
  Strand strand = strand_of(3);
  strand.mass = vector({1, 1, 3});
  strand.rest_length = vector({1, 1});
  const VectorXd x = vector({0, 0, 0, 1, 0, 0, 1, 1, 0});
  VectorXd v = vector({0, 0, 0, 0, 0, 0, 0.5, 4, 0.25});
  MatrixXd scratch(9, hair::kCorrectionScratch);
  correct_velocities(strand, x, 1e-12, 100000, v, scratch);
  expect_entries(
      v, vector({0, 0, 0, 0, 3, 0, 0.5, 3, 0.25}), 1e-11,
      "velocities after the impulse, particles at (0, 0), (1, 0), (1, 1) of 1, 1, 3 kg, the last one at "
      "(0.5, 4, 0.25) m/s",
      "ten times the tolerance");
}

int main(int argc, char** argv) {
  static const Strand strand = strand_of(1);
  static VectorXd x = VectorXd::Zero(3), v = x;
  static MatrixXd scratch(3, hair::kCorrectionScratch);
  return run(
      argc, argv,
      {{"relax_lengths", "RelaxLengths", [] { relax_lengths(strand, 1, 1, x); }},
       {"correct_lengths", "CorrectLengths", [] { correct_lengths(strand, 1, 1, x, scratch); }},
       {"correct_velocities", "CorrectVelocities", [] { correct_velocities(strand, x, 1, 1, v, scratch); }}});
}
