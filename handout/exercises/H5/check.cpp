// The public checks of H5. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/length_correction.h.

#include "hair/length_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "check.h"
#include "corrections.h"
#include "derivative.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::CorrectionReport;
using hair::Strand;

namespace {

const double kU = std::ldexp(1.0, -53);
const Vector3d kAlong = Vector3d(2, -1, 2) / 3;

// Allows no iteration to a straight strand of these lengths, with rest lengths of 0.8 and 2 m, so that the
// report's error is the input's.
void measures_the_error(Correction correction) {
  for (const auto& [first, second] : {std::pair{1.0, 2.0}, {0.6, 2.0}, {0.8, 2.5}, {0.4, 2.5}, {0.8, 1.2}}) {
    Strand strand = strand_of(3);
    strand.rest_length = vector({0.8, 2});
    VectorXd x(9);
    x << Vector3d::Zero(), first * kAlong, (first + second) * kAlong;
    const CorrectionReport report = correction(strand, 10, 0, x);
    EXPECT_NUMBER(report.error, largest_error(strand, x), 64 * kU)
        << "the error that is reported for segments of " << first << " m and " << second
        << " m, rest lengths 0.8 m and 2 m, no iteration allowed: the largest |l - l0| / l0";
  }
}

// The root at (0.5, 0, 0), and a segment along (0.6, 0.8, 0) of rest length 2 m.
void corrects_one_segment(Correction correction) {
  Strand strand = strand_of(2);
  strand.rest_length[0] = 2;
  for (const double length : {2.5, 0.5}) {
    VectorXd x = vector({0.5, 0, 0, 0.5 + 0.6 * length, 0.8 * length, 0});
    correction(strand, 1e-9, 100, x);
    expect_entries(x, vector({0.5, 0, 0, 1.7, 1.6, 0}), 1e-9,
                   "x of one segment along (0.6, 0.8, 0), rest length 2 m, " +
                       ::testing::PrintToString(length) + " m long before",
                   "the tolerance");
  }
}

// The strands' lengths are right already.
void says_that_it_converged(Correction correction) {
  for (int count : {1, 2, 3, 10}) {
    const Strand strand = strand_of(count);
    const VectorXd before = bent(strand, 0.05);
    VectorXd x = before;
    const CorrectionReport report = correction(strand, 1e-9, 100000, x);
    if (!(largest_error(strand, x) <= 1e-9)) continue;
    SCOPED_TRACE(std::to_string(count) + " particles, tolerance 1e-9, and all lengths are right afterwards");
    EXPECT_NUMBER(report.error, largest_error(strand, x), 64 * kU) << "the error that is reported";
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations > 0, largest_error(strand, before) > 1e-9) << report.iterations;
  }
}

void makes_lengths_right(Correction correction) {
  for (int count : {1, 2, 3, 10}) {
    const Strand strand = strand_of(count);
    const VectorXd before = bent(strand, 0.05);
    VectorXd x = before;
    correction(strand, 1e-9, 100000, x);
    SCOPED_TRACE(std::to_string(count) + " particles, tolerance 1e-9, at x = " + particles_in_words(before));
    EXPECT_LE(largest_error(strand, x), 1e-9 + 64 * kU) << "the largest |l - l0| / l0 that is left";
    EXPECT_EQ(x.head<3>(), before.head<3>()) << "the root moved";
  }
}

void moves_by_masses(Correction correction) {
  // 2.1 m long at rest, 2.5 m now; the root at one end, then masses of 2 and 3 kg.
  Strand strand = strand_of(3);
  strand.mass = vector({0.7, 2, 3});
  strand.rest_length = vector({0.8, 1.3});
  VectorXd x(9), right(9);
  x << Vector3d::Zero(), 0.8 * kAlong, 2.5 * kAlong;
  right << Vector3d::Zero(), 0.8 * kAlong, 2.1 * kAlong;
  correction(strand, 1e-12, 100000, x);
  expect_entries(x, right, 1e-11, "a straight strand of 0.8 and 1.7 m, corrected to 0.8 and 1.3 m",
                 "the tolerance, 1e-12, twice");
  // Only the second segment is wrong. Its ends move against each other by 1/mass, and the first segment then
  // pulls its own end back. Across a right angle the first segment does not notice a small error e.
  strand.rest_length = vector({2, 1.5});
  for (const double e : {1e-6, -1e-6}) {
    const VectorXd before = vector({0, 0, 0, 2, 0, 0, 2, 1.5 + e, 0});
    VectorXd corner = before;
    const int iterations = correction(strand, 1e-13, 100000, corner).iterations;
    const bool as_one_pass = (corner - before).head(6).isZero(0) && iterations == 1;
    if (as_one_pass)
      note_hint(
          "one pass of placing moves so: was a step refused whose sum of squares falls, or is lambda NaN?");
    expect_entries(
        corner - before, vector({0, 0, 0, 0, 0.6 * e, 0, 0, -0.4 * e, 0}), 10 * e * e + 1e-12,
        "the correction of a right angle of segments of 2 and 1.5 m, masses 2 and 3 kg; the second one is " +
            std::string(e > 0 ? "1e-6 m too long" : "1e-6 m too short") + "; " + std::to_string(iterations) +
            " iterations",
        "10 e^2 + 1e-12: second order, and the tolerance");
  }
}

// The root has a mass like the others, and is held.
void leaves_the_root_alone(Correction correction, const VectorXd& wrong) {
  VectorXd after = wrong;
  correction(strand_of(10), 1e-9, 3, after);
  EXPECT_EQ(after.head<3>(), wrong.head<3>()) << "the root, after three iterations at most";
}

// From the tip on, each segment gives to its outer end what it takes from its inner one: the momenta of
// particles i to the last one add up to an impulse along segment i - 1.
void expect_impulses_along(const Strand& strand, const VectorXd& x, const VectorXd& change, double bound,
                           const std::string& unit, const std::string& where, const std::string& source) {
  Vector3d impulse = Vector3d::Zero();
  for (int i = 9; i > 0; --i) {
    impulse += strand.mass[i] * change.segment<3>(3 * i);
    const Vector3d u = (x.segment<3>(3 * i) - x.segment<3>(3 * i - 3)).normalized();
    expect_entries(impulse - u.dot(impulse) * u, Vector3d::Zero(), bound,
                   unit + " across segment " + std::to_string(i - 1) + " of 9, which moves particles " +
                       std::to_string(i) + " to 9" + where,
                   source);
  }
}

// With errors of 1e-6 directions change by some 1e-5. Lengths are off both ways, or all too long.
void moves_by_impulses_along_the_segments(Correction correction, const Strand& strand) {
  for (const bool all_too_long : {false, true}) {
    const VectorXd before = all_too_long ? VectorXd((1 + 1e-6) * bent(strand, 0)) : bent(strand, 1e-6);
    VectorXd x = before;
    correction(strand, 1e-12, 100000, x);
    expect_impulses_along(
        strand, x, x - before, 1e-9, "kg m",
        std::string(", where lengths were ") + (all_too_long ? "too long" : "off") + " by 1e-6 m",
        "the change of directions, times a correction of 1e-5 kg m");
  }
}

// Crumpled, so that few iterations are enough.
void ends_for_a_long_strand(Correction correction) {
  const Strand strand = strand_of(10000);
  VectorXd wrong = bent(strand, 0.05, 3);
  EXPECT_LE(correction(strand, 1e-8, 1000, wrong).iterations, 1000)
      << "iterations for 10,000 particles. Each takes linear time: no full matrix";
}

// Allows all iterations that the correction needs, one less, and none.
void reports_what_it_did(Correction correction, const VectorXd& before,
                         double error(const Strand&, const VectorXd&)) {
  const Strand strand = strand_of(10);
  VectorXd right = before;
  const int needed = correction(strand, 1e-9, 100000, right).iterations;
  for (const int most : {needed, needed - 1, 0}) {
    SCOPED_TRACE("10 particles, tolerance 1e-9; of " + std::to_string(needed) +
                 " iterations that it needs, " + std::to_string(most) + " are allowed");
    VectorXd after = before;
    const CorrectionReport report = correction(strand, 1e-9, most, after);
    EXPECT_COUNT(report.iterations, most);
    EXPECT_EQ(report.converged, most == needed);
    EXPECT_NUMBER(report.error, error(strand, after), 64 * kU) << "the error of the returned values";
    EXPECT_EQ(after == before, most == 0) << "only with no iteration nothing changes";
  }
  const VectorXd kept = right;
  EXPECT_COUNT(correction(strand, 1e-9, 1000, right).iterations, 0) << "nothing is left to correct";
  EXPECT_EQ(right, kept) << "nothing was left to correct";
}

// One segment of rest length 0.5 m has an error of 0.25 or 0.25 m/s, without any rounding.
void leaves_an_error_that_is_the_tolerance(Correction correction, const VectorXd& before) {
  VectorXd lone = VectorXd::Zero(3);
  const CorrectionReport nothing = correction(strand_of(1), 1e-9, 100, lone);
  EXPECT_COUNT(nothing.iterations, 0) << "iterations for one particle, which has no segment";
  EXPECT_TRUE(nothing.converged) << "one particle, which has no segment";
  Strand strand = strand_of(2);
  strand.rest_length[0] = 0.5;
  VectorXd after = before;
  const CorrectionReport report = correction(strand, 0.25, 100, after);
  EXPECT_TRUE(report.converged) << "the error is 0.25, and the tolerance, too";
  EXPECT_EQ(after, before) << "the error is 0.25, and the tolerance, too";
}

void expect_few_or_sweeps(int iterations, int few, const std::string& of) {
  EXPECT_TRUE(iterations <= few || iterations >= 100)
      << iterations << " iterations for " << of << ": all segments at once take " << few
      << " at most, and sweeps take hundreds";
}

// The strand is nearly straight, since much bent hair takes few sweeps.
const double kLittleBent = 0.05;

void takes_few_iterations(Correction correction, VectorXd wrong, double tolerance, int few) {
  const CorrectionReport report = correction(strand_of(201), tolerance, 200000, wrong);
  EXPECT_TRUE(report.converged) << "a hair of 200 segments that is bent a little: it ended after "
                                << report.iterations << " of 200,000 iterations, with the error "
                                << report.error << ". Was it to go on?";
  expect_few_or_sweeps(report.iterations, few, "a hair of 200 segments that is bent a little");
}

void never_converges_with_nan(Correction correction, const VectorXd& right) {
  for (int i = 3; i < right.size(); ++i) {
    VectorXd x = right;
    x[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(correction(strand_of(10), 1e-6, 50, x).converged) << "entry " << i << " is not a number";
  }
}

// An error is relative to the rest length, and a direction is one, however short the segment is.
void works_in_every_unit(Correction correction) {
  VectorXd known = bent(strand_of(6), 0.05);
  correction(strand_of(6), 1e-8, 100000, known);
  for (const double unit : {0x1p-7, 0x1p-20, 0x1p-46}) {
    Strand strand = strand_of(6);
    VectorXd x = unit * bent(strand, 0.05);
    strand.rest_length *= unit;
    const CorrectionReport report = correction(strand, 1e-8, 100000, x);
    SCOPED_TRACE("segments of some " + ::testing::PrintToString(unit) + " m, tolerance 1e-8");
    EXPECT_LE(largest_error(strand, x), 1e-8 + 64 * kU) << "the largest |l - l0| / l0 that is left";
    EXPECT_TRUE(report.converged);
    expect_entries(x / unit, known, 1e-9, "x over that length, compared with x of segments of some metres",
                   "powers of two don't round");
  }
}

void is_honest_where_the_root_is_far(Correction correction) {
  for (const double far : {1e2, 1e6, 2e13, 5e13, 1e14, 1e18}) {
    const Strand strand = strand_of(6);
    VectorXd x = bent(strand, 0);
    x.head<3>() += far * kAlong;
    const CorrectionReport report = correction(strand, 1e-10, 1000, x);
    SCOPED_TRACE("6 particles, the root " + ::testing::PrintToString(far) + " m away, tolerance 1e-10");
    EXPECT_TRUE(far == 1e18 || x.allFinite());
    if (report.converged) {
      EXPECT_LE(largest_error(strand, x), 1e-10 + std::min(0x1p-48 * far, 2e-3))
          << "the report says that it has converged";
    }
  }
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

TEST(Report, MeasuresTheErrorByRelaxLengths) {
  measures_the_error(relax);
}

TEST(Report, LeavesAnErrorThatIsTheToleranceByRelaxLengths) {
  leaves_an_error_that_is_the_tolerance(relax, vector({0, 0, 0, 0, 0, -0.625}));
}

TEST(Relaxation, CorrectsOneSegment) {
  corrects_one_segment(relax);
}

TEST(Relaxation, SaysThatItConverged) {
  says_that_it_converged(relax);
}

TEST(Relaxation, MakesLengthsRight) {
  makes_lengths_right(relax);
}

TEST(Masses, MovesByMassesByRelaxLengths) {
  moves_by_masses(relax);
}

TEST(Root, LeavesTheRootAloneByRelaxLengths) {
  leaves_the_root_alone(relax, bent(strand_of(10), 1e-3));
}

TEST(Relaxation, MovesByImpulsesAlongTheSegments) {
  Strand strand = strand_of(10);
  strand.mass.setConstant(0.7);  // how masses count is asked elsewhere
  moves_by_impulses_along_the_segments(relax, strand);
}

TEST(LongStrands, EndsForALongStrandByRelaxLengths) {
  ends_for_a_long_strand(relax);
}

TEST(Report, ReportsWhatItDidByRelaxLengths) {
  reports_what_it_did(relax, bent(strand_of(10), 0.05), largest_error);
}

TEST(Iterations, TakesOneSweepForOneSegment) {
  const Strand strand = strand_of(2);
  VectorXd x = bent(strand, 0.05);
  EXPECT_COUNT(relax(strand, 1e-9, 1000, x).iterations, 1)
      << "sweeps for one segment: the first one is exact";
}

TEST(Report, NeverConvergesWithNaNByRelaxLengths) {
  never_converges_with_nan(relax, bent(strand_of(10), 0));
}

TEST(Units, WorksInEveryUnitByRelaxLengths) {
  works_in_every_unit(relax);
}

TEST(Relaxation, TakesSweepsThatGrowWithTheSquare) {
  std::printf(
      "A straight hair that is 1 %% too long, to 1e-10: your sweeps, for the table in the assignment\n");
  for (int segments : {10, 20, 30, 60})
    std::printf("  %d segments: %d", segments, iterations_for(relax, segments));
  std::printf("\n");
}

TEST(Report, MeasuresTheErrorByCorrectLengths) {
  measures_the_error(correct);
}

TEST(Report, LeavesAnErrorThatIsTheToleranceByCorrectLengths) {
  leaves_an_error_that_is_the_tolerance(correct, vector({0, 0, 0, 0, 0, -0.625}));
}

TEST(Lengths, CorrectsOneSegment) {
  corrects_one_segment(correct);
}

TEST(Lengths, SaysThatItConverged) {
  says_that_it_converged(correct);
}

TEST(Iterations, TakesFewIterationsByCorrectLengths) {
  std::printf("The same by correct_lengths: your iterations\n");
  for (int segments : {10, 20, 30, 60}) {
    const int iterations = iterations_for(correct, segments);
    std::printf("  %d segments: %d", segments, iterations);
    expect_few_or_sweeps(iterations, 8, "a straight hair of " + std::to_string(segments) + " segments");
  }
  std::printf("\n");
  takes_few_iterations(correct, bent(strand_of(201), 0.005, kLittleBent), 1e-10, 8);
  EXPECT_LE(iterations_for(correct, 1), 2) << "for one segment: the first step is exact. Has the root's mass "
                                              "a part in your matrix? 1/mass of it is 0";
}

TEST(Lengths, MakesLengthsRight) {
  makes_lengths_right(correct);
}

TEST(Masses, MovesByMassesByCorrectLengths) {
  moves_by_masses(correct);
}

TEST(Root, LeavesTheRootAloneByCorrectLengths) {
  leaves_the_root_alone(correct, bent(strand_of(10), 1e-3));
}

TEST(Impulses, MovesByImpulsesAlongTheSegments) {
  moves_by_impulses_along_the_segments(correct, strand_of(10));
}

TEST(LongStrands, EndsForALongStrandByCorrectLengths) {
  ends_for_a_long_strand(correct);
}

TEST(Report, ReportsWhatItDidByCorrectLengths) {
  reports_what_it_did(correct, bent(strand_of(10), 0.05), largest_error);
}

TEST(Report, NeverConvergesWithNaNByCorrectLengths) {
  never_converges_with_nan(correct, bent(strand_of(10), 0));
}

TEST(Units, WorksInEveryUnitByCorrectLengths) {
  works_in_every_unit(correct);
}

TEST(FarRoot, IsHonestWhereTheRootIsFar) {
  is_honest_where_the_root_is_far(correct);
}

TEST(Lengths, GivesTheSameHoweverOftenItIsAsked) {
  const Strand strand = strand_of(5);
  const VectorXd before = bent(strand, 0.05);
  VectorXd first = before;
  correct(strand, 1e-9, 1000, first);
  for (int i = 1; i <= kManyCalls; ++i) {
    VectorXd x = before;
    correct(strand, 1e-9, 1000, x);
    ASSERT_EQ(x, first) << "asked again for the same strand, " << i << " times so far";
  }
}

TEST(Degenerate, GivesASegmentOfNoLengthADirection) {
  Strand strand = strand_of(2);
  strand.rest_length[0] = 2;
  strand.root_tangent = Vector3d(0, 0.8, 0.6);
  VectorXd x = VectorXd::Zero(6);
  EXPECT_TRUE(correct(strand, 1e-9, 100000, x).converged);
  expect_entries(x, vector({0, 0, 0, 0, 1.6, 1.2}), 1e-8,
                 "two particles in one place, rest length 2 m, root_tangent (0, 0.8, 0.6)",
                 "ten times the tolerance");
  Strand longer = strand_of(4);
  VectorXd point = VectorXd::Ones(12);
  EXPECT_TRUE(correct(longer, 1e-9, 100000, point).converged) << "four particles in one place";
  EXPECT_LE(largest_error(longer, point), 1e-9 + 64 * kU) << "four particles in one place";
}

// One segment along z, and one along x behind it, get longer and shorter.
TEST(Report, MeasuresTheErrorByCorrectVelocities) {
  for (const auto& [first, second] : {std::pair{-0.5, 0.0}, {0.5, 0.0}, {0.25, 0.75}, {-0.75, -0.25}}) {
    VectorXd v = vector({0, 0, 0, 0, 0, first, second, 0, first});
    Strand strand = strand_of(3);
    strand.rest_length = vector({0.8, 1.5});
    const VectorXd x = vector({0, 0, 0, 0, 0, -0.8, 1.5, 0, -0.8});
    const CorrectionReport report = stop_at(x, strand, 10, 0, v);
    const double rate = std::max(std::abs(v[5] - v[2]), std::abs(v[6] - v[3]));
    EXPECT_NUMBER(report.error, rate, 64 * kU)
        << "the error that is reported for segments of 0.8 m along -z and 1.5 m along x, v = "
        << particles_in_words(v)
        << ", no iteration allowed: the largest |u . (v_(i+1) - v_i)|, m/s, over no length";
  }
}

TEST(Report, LeavesAnErrorThatIsTheToleranceByCorrectVelocities) {
  leaves_an_error_that_is_the_tolerance(
      [](const Strand& strand, double tolerance, int most, VectorXd& v) {
        return stop_at(VectorXd::Unit(v.size(), v.size() - 1), strand, tolerance, most, v);
      },
      vector({0, 0, 0, 0, 0, -0.25}));
}

TEST(Velocities, CorrectsOneSegment) {
  const Strand strand = strand_of(2);
  const VectorXd x = strand.rest_length[0] * vector({0, 0, 0, 0.6, 0.8, 0});
  for (const double rate : {5.0, -5.0}) {
    const VectorXd before = vector({0, 0, 0, 0.6 * rate, 0.8 * rate, 1});
    VectorXd v = before;
    stop_at(x, strand, 1e-9, 100, v);
    expect_entries(v, vector({0, 0, 0, 0, 0, 1}), 1e-9,
                   "velocities of a segment along (0.6, 0.8, 0), its outer end at "
                   "(0, 0, 1) and " +
                       ::testing::PrintToString(rate) + " times (0.6, 0.8, 0) m/s",
                   "the tolerance", before);
  }
}

TEST(Velocities, SaysThatItConverged) {
  for (int count : {1, 2, 3, 10}) {
    const Strand strand = strand_of(count);
    VectorXd v = scattered_vector(3 * count, 7);
    const CorrectionReport report = stop(strand, 1e-9, 100000, v);
    if (!(largest_rate(strand, v) <= 1e-9)) continue;
    SCOPED_TRACE(std::to_string(count) +
                 " particles, tolerance 1e-9 m/s, and no segment is stretched any more");
    EXPECT_NUMBER(report.error, largest_rate(strand, v), 256 * kU) << "the error that is reported";
    EXPECT_TRUE(report.converged);
  }
}

TEST(Velocities, StopStretching) {
  for (int count : {1, 2, 3, 10}) {
    const Strand strand = strand_of(count);
    const VectorXd before = scattered_vector(3 * count, 7);
    VectorXd v = before;
    stop(strand, 1e-9, 100000, v);
    SCOPED_TRACE(std::to_string(count) +
                 " particles, tolerance 1e-9 m/s, at x = " + particles_in_words(bent(strand, 0)));
    EXPECT_EQ(v.head<3>(), before.head<3>()) << "the root's velocity changed";
    EXPECT_LE(largest_rate(strand, v), 1e-9 + 256 * kU) << "the rate at which a segment is stretched, m/s";
  }
}

TEST(Root, LeavesTheRootAloneByCorrectVelocities) {
  leaves_the_root_alone(stop, scattered_vector(30, 7));
}

TEST(LongStrands, EndsForALongStrandByCorrectVelocities) {
  ends_for_a_long_strand([](const Strand& strand, double tolerance, int most, VectorXd& v) {
    return stop_at(bent(strand, 0.05, 3), strand, tolerance, most, v);
  });
}

TEST(Report, ReportsWhatItDidByCorrectVelocities) {
  reports_what_it_did(stop, scattered_vector(30, 7), largest_rate);
}

TEST(Iterations, TakesFewIterationsByCorrectVelocities) {
  takes_few_iterations(
      [](const Strand& strand, double tolerance, int most, VectorXd& v) {
        return stop_at(bent(strand, 0, kLittleBent), strand, tolerance, most, v);
      },
      scattered_vector(603, 7), 1e-9, 4);
}

TEST(Report, NeverConvergesWithNaNByCorrectVelocities) {
  never_converges_with_nan(stop, VectorXd::Zero(30));
}

TEST(Iterations, OfOneSegmentAtOnce) {
  const Strand strand = strand_of(2);
  VectorXd v = scattered_vector(6, 7);
  EXPECT_LE(stop(strand, 1e-9, 1000, v).iterations, 2)
      << "iterations for one segment: the first impulse is exact. 1/mass of the root is 0";
}

TEST(Degenerate, OfASegmentOfNoLength) {
  Strand strand = strand_of(2);
  strand.root_tangent = Vector3d(0, 1, 0);
  VectorXd v = vector({0, 0, 0, 1, 2, 3});
  stop_at(VectorXd::Ones(6), strand, 1e-9, 1000, v);
  expect_entries(
      v, vector({0, 0, 0, 1, 0, 3}), 1e-8,
      "velocities of two particles in one place, root_tangent (0, 1, 0), the second one at (1, 2, 3) m/s",
      "ten times the tolerance");
}

TEST(Velocities, ByImpulsesAlongTheSegments) {
  const Strand strand = strand_of(10);
  const VectorXd before = scattered_vector(30, 7);
  VectorXd v = before;
  stop(strand, 1e-12, 100000, v);
  expect_impulses_along(strand, bent(strand, 0), v - before, 1e-12, "N s", "",
                        "rounding of some 100 impulses of 10 N s at most");
}

TEST(Masses, ByEqualAndOppositeImpulses) {
  // Across a right angle the first segment does not feel the second one's impulse, so this is a collision of
  // 2 and 3 kg.
  Strand strand = strand_of(3);
  strand.mass = vector({0.7, 2, 3});
  strand.rest_length = vector({0.8, 1.5});
  const VectorXd x = vector({0, 0, 0, 0.8, 0, 0, 0.8, 1.5, 0});
  VectorXd v = vector({0, 0, 0, 0, 0, 0, 0.5, 4, 0.25});
  MatrixXd scratch(9, hair::kCorrectionScratch);
  correct_velocities(strand, x, 1e-12, 100000, v, scratch);
  expect_entries(v, vector({0, 0, 0, 0, 2.4, 0, 0.5, 2.4, 0.25}), 1e-11,
                 "velocities after the impulse, particles at (0, 0), (0.8, 0), (0.8, 1.5) of 0.7, 2, 3 kg, "
                 "the last one at "
                 "(0.5, 4, 0.25) m/s",
                 "ten times the tolerance");
}

int main(int argc, char** argv) {
  static const Strand strand = strand_of(1);
  static VectorXd x = VectorXd::Zero(3), v = x;
  static MatrixXd scratch(3, hair::kCorrectionScratch);
  return run(argc, argv,
             {{"relax_lengths", [] { relax_lengths(strand, 1, 1, x); }},
              {"correct_lengths", [] { correct_lengths(strand, 1, 1, x, scratch); }},
              {"correct_velocities", [] { correct_velocities(strand, x, 1, 1, v, scratch); }}});
}
