// The public checks of H1. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/stretch_springs.h.

#include "hair/stretch_springs.h"

#include <gtest/gtest.h>

#include "check.h"
#include "derivative.h"
#include "strands.h"

using namespace checks;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::GeometricTerm;
using hair::Strand;

namespace {

// EA = 12 N
Strand strand_of(const VectorXd& rest_length) {
  return strand_with(&Strand::stretch_rigidity, 12, rest_length);
}

// Rest lengths between 0.5 and 1.5 m; bent all over, each segment 0.6 to 1.6 times as long as at rest.
Case bent(int count, int which) {
  const VectorXd numbers = scattered_vector(5 * count, which);
  Case result{strand_of(VectorXd::Ones(count - 1) + numbers.head(count - 1) / 2), VectorXd::Zero(3 * count)};
  for (int i = 0; i + 1 < count; ++i) {
    const Vector3d direction = (Vector3d(0, 0, -0.7) + numbers.segment<3>(count + 3 * i) / 2).normalized();
    const double stretch = 1.1 + numbers[4 * count + i] / 2;
    result.x.segment<3>(3 * i + 3) =
        result.x.segment<3>(3 * i) + stretch * result.strand.rest_length[i] * direction;
  }
  return result;
}

VectorXd force(const Strand& strand, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  add_stretch_force(strand, x, f);
  return f;
}

VectorXd product(const Strand& strand, const VectorXd& x, GeometricTerm term, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  add_stretch_product(strand, x, term, dx, df);
  return df;
}

// `power`: of the unit of length, in the answer.
template <class Answer>
void expect_in_units(const Answer& answer, int power, const std::string& what) {
  const Case c = bent(6, 9);
  checks::expect_in_units(answer, c, {-90, -50, 30}, power, 1e-12, what);
  expect_in_proportion(answer, c, &Strand::stretch_rigidity, "EA", what);
}

const Strand kMetre = strand_of(vector({1}));  // k = EA / l0 = 12 N/m
const VectorXd kMetreStretched = vector({0, 1, 0, 0, 1, -1.625});
const VectorXd kMetreCompressed = vector({0, 1, 0, 0, 1, -0.6875});
const Strand kOne = strand_of(vector({2}));                   // k = EA / l0 = 6 N/m
const VectorXd kStretched = vector({1, 0, 0, 1, 0, -2.5});    // 0.5 m too long
const VectorXd kCompressed = vector({1, 0, 0, 1, 0, -1.25});  // 0.75 m too short
// The same spring, stretched, behind one whose ends meet.
const Strand kPair = strand_of(vector({2, 2}));
const VectorXd kMeeting = vector({1, 0, 0, 1, 0, 0, 1, 0, -2.5});

// A product of kOne: `dx` times `expected` at the tip, and the opposite at the root.
struct Row {
  const VectorXd &x, &dx;
  GeometricTerm term;
  double expected;
  const char* name;
};
const VectorXd kAlong = vector({0, 0, 0, 0, 0, 1}), kAcross = vector({0, 0, 0, 1, 0, 0});

void expect_rows(std::initializer_list<Row> rows) {
  for (const Row& row : rows) {
    VectorXd expected = row.expected * row.dx;
    expected.head<3>() = -expected.tail<3>();
    expect_entries(product(kOne, row.x, row.term, row.dx), expected, 64 * kU * 12,
                   "the product of one spring, k = 6 N/m, " + std::string(row.name) +
                       ", dx = " + particles_in_words(row.dx),
                   "64 u of k (1 + l0/l): rounding");
  }
}

}  // namespace

TEST(Energy, OfOneSpring) {
  SCOPED_TRACE("EA = 12 N, one segment of rest length 1 m: k = 12 N/m");
  EXPECT_DOUBLE_EQ(stretch_energy(kMetre, kMetreStretched), 2.34375) << "1.625 m long: 12 * 0.625^2 / 2 J";
  EXPECT_DOUBLE_EQ(stretch_energy(kMetre, kMetreCompressed), 0.5859375)
      << "0.6875 m long: 12 * 0.3125^2 / 2 J";
}

TEST(Sampling, OfASpringOfTwoMetresByStretchEnergy) {
  SCOPED_TRACE("EA = 12 N, one segment of rest length 2 m and length 2.5 m: k = 6 N/m, E = 6 * 0.5^2 / 2 J");
  EXPECT_DOUBLE_EQ(stretch_energy(kOne, kStretched), 0.75);
  EXPECT_DOUBLE_EQ(stretch_energy(kOne, kCompressed), 1.6875) << "compressed to 1.25 m: 6 * 0.75^2 / 2 J";
}

TEST(Sampling, DoesNotDependOnTheSampling) {
  look_at("sum");
  // 3 m, stretched to 3.3 m: E = EA * 0.1^2 / 2 * 3 m, in however many segments.
  for (int segments : {1, 3, 5, 7}) {
    const Strand strand = strand_of(VectorXd::Constant(segments, 3.0 / segments));
    VectorXd x = VectorXd::Zero(3 * segments + 3);
    for (int i = 0; i <= segments; ++i) x[3 * i + 2] = -3.3 * i / segments;
    EXPECT_NUMBER(stretch_energy(strand, x), 12 * 0.01 / 2 * 3, 1e-12)
        << segments
        << " segments of 3 m in all, stretched by 10 %; EA = 12 N; bound: rounding, 64 u of E over 0.1";
  }
}

TEST(NoDirection, OfASegmentWithoutLength) {
  look_at("energy");
  EXPECT_DOUBLE_EQ(stretch_energy(kOne, vector({1, 2, 3, 1, 2, 3})), 12)
      << "EA = 12 N, rest length 2 m, two particles in the same place: 6 * 2^2 / 2 J";
}

TEST(Extremes, InAnyUnitByStretchEnergy) {
  expect_in_units([](const Strand& strand, const VectorXd& x) { return vector({stretch_energy(strand, x)}); },
                  1, "the energy");
}

TEST(NoDirection, OfOneParticleIsZero) {
  look_at("energy");
  EXPECT_NUMBER(stretch_energy(strand_of(VectorXd(0)), vector({1, 2, 3})), 0, 0);
}

TEST(Forces, OfOneSpring) {
  for (const auto& [x, pull] : {std::pair{kMetreStretched, 7.5}, {kMetreCompressed, -3.75}})
    expect_entries(force(kMetre, x), vector({0, 0, -pull, 0, 0, pull}), 32 * kU * 12 * 2.5,
                   "the force of one spring, EA = 12 N, l0 = 1 m, at x = " + particles_in_words(x),
                   "32 u of k (l + l0): rounding");
}

TEST(Sampling, OfASpringOfTwoMetresByAddStretchForce) {
  const std::string source = "32 u of k (l + l0): rounding";
  expect_entries(force(kOne, kStretched), vector({0, 0, -3, 0, 0, 3}), 32 * kU * 6 * 4.5,
                 "the force of one spring, EA = 12 N, l0 = 2 m, at x = " + particles_in_words(kStretched),
                 source);
  expect_entries(force(kOne, kCompressed), vector({0, 0, 4.5, 0, 0, -4.5}), 32 * kU * 6 * 3.25,
                 "the force of one spring, EA = 12 N, l0 = 2 m, at x = " + particles_in_words(kCompressed),
                 source);
}

TEST(Forces, IsMinusTheEnergysGradient) {
  look_at("neighbours");
  for (int count : {2, 3, 7}) {
    const Case c = bent(count, count);
    // The shortest segment is not below 0.3 m; EA is the force at twice the length.
    expect_force(
        force(c.strand, c.x), [&](const VectorXd& x) { return stretch_energy(c.strand, x); }, c.x, 0.3, 12);
  }
}

TEST(Forces, GivesNoNetForceOrTorque) {
  look_at("other-end");
  const Case c = bent(9, 3);
  const VectorXd f = force(c.strand, c.x);
  EXPECT_GT(f.norm(), 1) << "no force at all";
  expect_balanced(f, c.x, 9 * 32 * kU * 36, "rounding: 32 u of EA (1 + l/l0) for each of 9 particles");
}

TEST(Added, IsAddedToWhatFHolds) {
  const Case c = bent(5, 1);
  expect_added([&](VectorXd& f) { add_stretch_force(c.strand, c.x, f); }, scattered_vector(15, 8),
               8 * kU * 36, "f");
}

TEST(Extremes, InAnyUnitByAddStretchForce) {
  expect_in_units(force, 0, "the force");
}

TEST(Extremes, OfALongStrand) {
  look_at("crash");
  const int n = 10000;
  const Strand strand = strand_of(VectorXd::Ones(n - 1));
  VectorXd x = VectorXd::Zero(3 * n);
  for (int i = 0; i < n; ++i) x[3 * i + 2] = -1.25 * i;
  const VectorXd f = force(strand, x);
  EXPECT_NUMBER(f[2], -3, 0)
      << "the force on the root of 10,000 particles, EA = 12 N, stretched by a quarter";
  EXPECT_NUMBER(f[3 * n - 1], 3, 0) << "the force on the tip of the same strand";
}

TEST(NoDirection, OfASegmentWithoutLengthIsZeroByAddStretchForce) {
  const VectorXd f = force(kOne, vector({1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(f, VectorXd::Zero(6)) << "two particles in the same place; actual: " << particles_in_words(f);
}

TEST(NoDirection, OfTheSegmentsBehindOneWithoutLengthStaysByAddStretchForce) {
  look_at("goes-on");
  expect_entries(force(kPair, kMeeting), vector({0, 0, 0, 0, 0, -3, 0, 0, 3}), 32 * kU * 6 * 4.5,
                 "the force at x = " + particles_in_words(kMeeting) +
                     ": the first two particles meet, and the "
                     "second spring is the one above",
                 "32 u of k (l + l0): rounding");
}

// Along the spring: -k. Across: -k (1 - l0/l), which is -6 * 0.2 stretched, and -6 * -0.6 compressed.
TEST(ExactProduct, OfOneSpring) {
  expect_rows({{kStretched, kAlong, GeometricTerm::full, -6, "stretched, along, full"},
               {kStretched, kAcross, GeometricTerm::full, -1.2, "stretched, across, full"},
               {kCompressed, kAcross, GeometricTerm::full, 3.6, "compressed, across, full"}});
}

TEST(FilteredProduct, LetsThroughWhatItIsToldTo) {
  expect_rows({{kStretched, kAlong, GeometricTerm::dropped, -6, "stretched, along, dropped"},
               {kStretched, kAcross, GeometricTerm::filtered, -1.2, "stretched, across, filtered"},
               {kStretched, kAcross, GeometricTerm::dropped, 0, "stretched, across, dropped"},
               {kCompressed, kAlong, GeometricTerm::filtered, -6, "compressed, along, filtered"},
               {kCompressed, kAcross, GeometricTerm::filtered, 0, "compressed, across, filtered"},
               {kCompressed, kAcross, GeometricTerm::dropped, 0, "compressed, across, dropped"}});
}

TEST(ExactProduct, IsTheForcesDerivative) {
  look_at("neighbours");
  for (int count : {2, 3, 7}) {
    const Case c = bent(count, count + 20);
    const VectorXd dx = scattered_vector(3 * count, 5);
    // 36 N/m: k (1 + l0/l) of the stiffest spring.
    expect_product(
        product(c.strand, c.x, GeometricTerm::full, dx),
        [&](const VectorXd& x) { return force(c.strand, x); }, c.x, dx, 0.3, 64);
  }
}

TEST(ExactProduct, IsSymmetric) {
  look_at("symmetric");
  const Case c = bent(8, 2);
  expect_symmetric_terms(
      [&](GeometricTerm term, const VectorXd& dx) { return product(c.strand, c.x, term, dx); }, 24,
      24 * 64 * kU * 64, "24 entries, 64 u of k (1 + l0/l) each: rounding");
}

TEST(FilteredProduct, WithoutTheNegativeTermIsNegativeSemidefinite) {
  look_at("each-segment");
  const Case c = bent(8, 4);
  expect_negative_semidefinite(
      [&](GeometricTerm term, const VectorXd& dx) { return product(c.strand, c.x, term, dx); }, 24,
      24 * 64 * kU * 64, "24 entries, 64 u of k (1 + l0/l) each: rounding");
}

TEST(Added, IsAddedToWhatDfHolds) {
  const Case c = bent(5, 6);
  const VectorXd dx = scattered_vector(15, 2);
  expect_added([&](VectorXd& df) { add_stretch_product(c.strand, c.x, GeometricTerm::full, dx, df); },
               scattered_vector(15, 9), 8 * kU * 128, "df");
}

TEST(Extremes, InAnyUnitByAddStretchProduct) {
  const VectorXd dx = scattered_vector(18, 3);
  for (const GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
    expect_in_units([&](const Strand& strand, const VectorXd& x) { return product(strand, x, term, dx); }, -1,
                    "the product");
}

TEST(NoDirection, OfASegmentWithoutLengthIsZeroByAddStretchProduct) {
  for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped}) {
    const VectorXd df = product(kOne, vector({1, 2, 3, 1, 2, 3}), term, vector({1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(df, VectorXd::Zero(6)) << "two particles in the same place; actual: " << particles_in_words(df);
  }
}

TEST(NoDirection, OfTheSegmentsBehindOneWithoutLengthStaysByAddStretchProduct) {
  look_at("goes-on");
  const VectorXd dx = vector({0, 0, 0, 0, 0, 0, 0, 0, 1});
  for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
    expect_entries(product(kPair, kMeeting, term, dx), vector({0, 0, 0, 0, 0, 6, 0, 0, -6}), 64 * kU * 12,
                   "the product at x = " + particles_in_words(kMeeting) +
                       ", where the first two particles meet, "
                       "dx = " +
                       particles_in_words(dx),
                   "64 u of k (1 + l0/l): rounding");
}

int main(int argc, char** argv) {
  static const Strand lone = strand_of(VectorXd(0));
  static const VectorXd x = VectorXd::Zero(3);
  static VectorXd out = x;
  return run(argc, argv,
             {{"stretch_energy", [] { stretch_energy(lone, x); }},
              {"add_stretch_force", [] { add_stretch_force(lone, x, out); }, {"stretch_energy"}},
              {"add_stretch_product",
               [] { add_stretch_product(lone, x, GeometricTerm::full, x, out); },
               {"add_stretch_force"}}});
}
