// The public checks of H3. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/bend_springs.h.

#include "hair/bend_springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "check.h"
#include "derivative.h"
#include "strands.h"

using namespace checks;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::GeometricTerm;
using hair::Strand;

namespace {

// skip_rigidity = 10 N
Strand strand_of(const VectorXd& rest_length) {
  return strand_with(&Strand::skip_rigidity, 10, rest_length);
}

// Rest lengths between 0.5 and 1.5 m, bent by up to a right angle or so; lengths of 0.6 to 1.6 m.
Case bent(int count, int which) {
  const VectorXd numbers = scattered_vector(5 * count, which);
  Case result{strand_of(VectorXd::Ones(count - 1) + numbers.head(count - 1) / 2), VectorXd::Zero(3 * count)};
  for (int i = 0; i + 1 < count; ++i) {
    const Vector3d direction = (Vector3d(0, 0, -1) + numbers.segment<3>(count + 3 * i) / 2).normalized();
    result.x.segment<3>(3 * i + 3) =
        result.x.segment<3>(3 * i) + (1.1 + numbers[4 * count + i] / 2) * direction;
  }
  return result;
}

VectorXd force(const Strand& strand, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  add_bend_spring_force(strand, x, f);
  return f;
}

VectorXd product(const Strand& strand, const VectorXd& x, GeometricTerm term, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  add_bend_spring_product(strand, x, term, dx, df);
  return df;
}

// `power`: of the unit of length, in the answer.
template <class Answer>
void expect_in_units(const Answer& answer, int power, const std::string& what) {
  const Case c = bent(6, 9);
  checks::expect_in_units(answer, c, {-90, -50, 30}, power, 1e-12, what);
  expect_in_proportion(answer, c, &Strand::skip_rigidity, "skip_rigidity", what);
}

const Strand kMetre = strand_of(vector({0.5, 0.5}));  // d0 = 1 m, k = 10 N/m
const VectorXd kMetreBent = vector({0, 0, 0, 0.5, 0.25, 0, 0, 0.75, 0});
const VectorXd kMetreLong = vector({0, 0, 0, 0.5, 0.25, 0, 0, 1.625, 0});
const Strand kTwo = strand_of(vector({1.5, 2.5}));               // d0 = 4 m, k = 2.5 N/m
const VectorXd kBent = vector({0, 0, 0, 0, 1.5, 0, 0, 1.5, 2});  // d = 2.5 m
const VectorXd kLong = vector({0, 0, 0, 0, 0.5, -3, 0, 0, -5});  // d = 5 m
const VectorXd kMeeting = vector({1, 2, 3, 1, 3, 3, 1, 2, 3});   // d = 0
// The second spring is kTwo's at d = 5 m, from particle 1 to 3. The first one's ends meet.
const Strand kThree = strand_of(vector({1, 1.5, 2.5}));
const VectorXd kFirstMeets = vector({0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -5});

}  // namespace

TEST(Energy, OfOneSpring) {
  SCOPED_TRACE("skip_rigidity = 10 N, rest lengths 0.5 m and 0.5 m: d0 = 1 m, k = 10 N/m");
  EXPECT_DOUBLE_EQ(bend_spring_energy(kMetre, kMetreBent), 0.3125) << "d = 0.75 m: 10 * 0.25^2 / 2 J";
  EXPECT_DOUBLE_EQ(bend_spring_energy(kMetre, kMetreLong), 1.953125) << "d = 1.625 m: 10 * 0.625^2 / 2 J";
}

TEST(Lengths, OfASpringOfFourMetresByBendSpringEnergy) {
  SCOPED_TRACE("skip_rigidity = 10 N, rest lengths 1.5 m and 2.5 m: d0 = 4 m, k = 2.5 N/m");
  EXPECT_DOUBLE_EQ(bend_spring_energy(kTwo, kBent), 2.8125) << "d = 2.5 m: 2.5 * 1.5^2 / 2 J";
  EXPECT_DOUBLE_EQ(bend_spring_energy(kTwo, kLong), 1.25) << "d = 5 m: 2.5 * 1^2 / 2 J";
}

TEST(Energy, SumsAllSprings) {
  look_at("sum");
  const Strand strand = strand_of(vector({1, 1, 2, 3}));  // d0 = 2, 3 and 5 m, k = 5, 10/3 and 2 N/m
  EXPECT_NUMBER(bend_spring_energy(strand, vector({0, 0, 0, 0, 0, -1, 0, 0, -3, 0, 0, -5, 0, 0, -9})),
                (5 * 1 + 10.0 / 3 * 1 + 2 * 1) / 2, 1e-13)
      << "a straight strand whose springs are 3, 4 and 6 m long, d0 = 2, 3 and 5 m, skip_rigidity = 10 N; "
         "bound: "
         "rounding";
}

TEST(Energy, SeesStretchingAndHardlyBending) {
  look_at("rest");
  const Strand strand = strand_of(vector({1, 1}));  // k = 5 N/m
  EXPECT_NUMBER(bend_spring_energy(strand, vector({0, 0, 0, 0, 0, -1.01, 0, 0, -2.02})), 5 * 4e-4 / 2, 1e-15)
      << "straight, stretched by 1 %: d - d0 = 0.02 m; bound: rounding";
  // Both segments 1 m, a right turn by 0.01: d = 2 cos(0.005), d - d0 = -2.5e-5 m to fourth order.
  const double E =
      bend_spring_energy(strand, vector({0, 0, 0, 0, 0, -1, 0, std::sin(0.01), -1 - std::cos(0.01)}));
  const double multiplied_out = 4 * 0x1p-53 * 5 * (2 + 2) * (2 + 2) / 2;
  EXPECT_NUMBER(E, 5 * std::pow(4 * std::pow(std::sin(0.0025), 2), 2) / 2, 1e-9 * E + multiplied_out)
      << "bent by 0.01: the energy is of fourth order in the angle; bound: rounding of d, 8 u, over 2.5e-5, "
         "or of "
         "the terms of (d - d0)^2, if it is multiplied out";
}

TEST(NoDirection, OfParticlesThatMeet) {
  EXPECT_DOUBLE_EQ(bend_spring_energy(kTwo, kMeeting), 20)
      << "particles 0 and 2 in the same place, d0 = 4 m, k = 2.5 N/m: 2.5 * 4^2 / 2 J";
}

TEST(Lengths, InAnyUnitByBendSpringEnergy) {
  look_at("limit");
  expect_in_units(
      [](const Strand& strand, const VectorXd& x) { return vector({bend_spring_energy(strand, x)}); }, 1,
      "the energy");
}

TEST(NoDirection, OfFewerThanThreeParticlesIsZero) {
  look_at("crash");
  EXPECT_NUMBER(bend_spring_energy(strand_of(VectorXd(0)), vector({1, 2, 3})), 0, 0) << "one particle";
  EXPECT_NUMBER(bend_spring_energy(strand_of(vector({1})), vector({1, 2, 3, 4, 5, 6})), 0, 0)
      << "two particles";
}

TEST(Forces, OfOneSpring) {
  for (const auto& [x, pull] : {std::pair{kMetreBent, -2.5}, {kMetreLong, 6.25}})
    expect_entries(force(kMetre, x), vector({0, pull, 0, 0, 0, 0, 0, -pull, 0}), 64 * kU * 10 * 2.5,
                   "the force of one spring, k = 10 N/m, d0 = 1 m, at x = " + particles_in_words(x),
                   "64 u of k (d + d0): rounding");
}

TEST(Lengths, OfASpringOfFourMetresByAddBendSpringForce) {
  look_at("force");
  const std::string source = "64 u of k (d + d0): rounding";
  // k (d - d0) = -3.75 N, along (0, 0.6, 0.8), from particle 0 to particle 2; nothing on particle 1.
  expect_entries(force(kTwo, kBent), vector({0, -2.25, -3, 0, 0, 0, 0, 2.25, 3}), 64 * kU * 2.5 * 6.5,
                 "the force of one spring, k = 2.5 N/m, d0 = 4 m, at x = " + particles_in_words(kBent),
                 source);
  expect_entries(force(kTwo, kLong), vector({0, 0, -2.5, 0, 0, 0, 0, 0, 2.5}), 64 * kU * 2.5 * 9,
                 "the force of one spring, k = 2.5 N/m, d0 = 4 m, at x = " + particles_in_words(kLong),
                 source);
}

TEST(Forces, IsMinusTheEnergysGradient) {
  look_at("neighbours");
  for (int count : {3, 4, 8}) {
    const Case c = bent(count, count);
    expect_force(
        force(c.strand, c.x), [&](const VectorXd& x) { return bend_spring_energy(c.strand, x); }, c.x, 1, 10);
  }
}

TEST(Forces, GivesNoNetForceOrTorque) {
  look_at("other-end");
  const Case c = bent(9, 3);
  const VectorXd f = force(c.strand, c.x);
  EXPECT_GT(f.norm(), 1) << "no force at all";
  expect_balanced(f, c.x, 9 * 64 * kU * 40, "rounding: 64 u of k (d + d0) for each of 9 particles");
}

TEST(Added, IsAddedToWhatFHolds) {
  const Case c = bent(6, 1);
  expect_added([&](VectorXd& f) { add_bend_spring_force(c.strand, c.x, f); }, scattered_vector(18, 8),
               8 * kU * 40, "f");
}

TEST(Lengths, InAnyUnitByAddBendSpringForce) {
  look_at("limit");
  expect_in_units(force, 0, "the force");
}

TEST(EverySpring, OfALongStrand) {
  const int n = 10000;
  const Strand strand = strand_of(VectorXd::Ones(n - 1));  // k = 5 N/m
  VectorXd x = VectorXd::Zero(3 * n);
  for (int i = 0; i < n; ++i) x[3 * i + 2] = -1.25 * i;
  const VectorXd f = force(strand, x);
  for (const int i : {0, 1}) {
    EXPECT_NUMBER(f[3 * i + 2], -2.5, 0)
        << "the force on particle " << i << " of 10,000, skip_rigidity = 10 N, "
        << "stretched by a quarter";
    EXPECT_NUMBER(f[3 * (n - 1 - i) + 2], 2.5, 0)
        << "the force on particle " << n - 1 - i << " of the same strand";
  }
}

TEST(NoDirection, OfParticlesThatMeetIsZeroByAddBendSpringForce) {
  const VectorXd f = force(kTwo, kMeeting);
  EXPECT_EQ(f, VectorXd::Zero(9)) << "particles 0 and 2 in the same place; actual: " << particles_in_words(f);
}

TEST(NoDirection, OfTheSpringsBehindOneWithoutLengthStaysByAddBendSpringForce) {
  look_at("goes-on");
  expect_entries(force(kThree, kFirstMeets), vector({0, 0, 0, 0, 0, -2.5, 0, 0, 0, 0, 0, 2.5}),
                 32 * kU * 2.5 * 9,
                 "the force at x = " + particles_in_words(kFirstMeets) +
                     ": particles 0 and 2 meet, 1 and 3 are 5 m apart, d0 = 4 m, k = 2.5 N/m",
                 "32 u of k (d + d0): rounding");
}

TEST(ExactProduct, IsTheForcesDerivative) {
  for (int count : {3, 4, 8}) {
    const Case c = bent(count, count + 20);
    const VectorXd dx = scattered_vector(3 * count, 5);
    expect_product(
        product(c.strand, c.x, GeometricTerm::full, dx),
        [&](const VectorXd& x) { return force(c.strand, x); }, c.x, dx, 1, 40);
  }
}

TEST(FilteredProduct, LetsThroughWhatItIsToldTo) {
  const VectorXd across = vector({1, 0, 0, 0, 0, 0, 0, 0, 0});
  struct Row {
    const VectorXd& x;
    GeometricTerm term;
    double expected;  // -k (1 - d0/d)
    const char* name;
  };
  for (const Row& row : {Row{kLong, GeometricTerm::full, -0.5, "longer than at rest, full"},
                         Row{kLong, GeometricTerm::filtered, -0.5, "longer than at rest, filtered"},
                         Row{kLong, GeometricTerm::dropped, 0, "longer than at rest, dropped"},
                         Row{kBent, GeometricTerm::full, 1.5, "shorter than at rest, full"},
                         Row{kBent, GeometricTerm::filtered, 0, "shorter than at rest, filtered"},
                         Row{kBent, GeometricTerm::dropped, 0, "shorter than at rest, dropped"}}) {
    expect_entries(
        product(kTwo, row.x, row.term, across), row.expected * vector({1, 0, 0, 0, 0, 0, -1, 0, 0}),
        64 * kU * 2.5 * 3,
        "the product of one spring, k = 2.5 N/m, d0 = 4 m, with a dx across it, " + std::string(row.name),
        "64 u of k (1 + d0/d): rounding");
  }
}

TEST(ExactProduct, IsSymmetric) {
  look_at("symmetric");
  const Case c = bent(8, 2);
  expect_symmetric_terms(
      [&](GeometricTerm term, const VectorXd& dx) { return product(c.strand, c.x, term, dx); }, 24,
      24 * 64 * kU * 40, "24 entries, 64 u of k (1 + d0/d) each: rounding");
}

TEST(FilteredProduct, WithoutTheNegativeTermIsNegativeSemidefinite) {
  look_at("each-spring");
  const Case c = bent(8, 4);
  expect_negative_semidefinite(
      [&](GeometricTerm term, const VectorXd& dx) { return product(c.strand, c.x, term, dx); }, 24,
      24 * 64 * kU * 40, "24 entries, 64 u of k (1 + d0/d) each: rounding");
}

TEST(Added, IsAddedToWhatDfHolds) {
  const Case c = bent(6, 6);
  const VectorXd dx = scattered_vector(18, 2);
  expect_added([&](VectorXd& df) { add_bend_spring_product(c.strand, c.x, GeometricTerm::full, dx, df); },
               scattered_vector(18, 9), 8 * kU * 80, "df");
}

TEST(Lengths, InAnyUnitByAddBendSpringProduct) {
  look_at("limit");
  const VectorXd dx = scattered_vector(18, 3);
  for (const GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
    expect_in_units([&](const Strand& strand, const VectorXd& x) { return product(strand, x, term, dx); }, -1,
                    "the product");
}

TEST(NoDirection, OfParticlesThatMeetIsZeroByAddBendSpringProduct) {
  for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped}) {
    const VectorXd df = product(kTwo, kMeeting, term, scattered_vector(9, 1));
    EXPECT_EQ(df, VectorXd::Zero(9)) << "particles 0 and 2 in the same place; actual: "
                                     << particles_in_words(df);
  }
}

TEST(NoDirection, OfTheSpringsBehindOneWithoutLengthStaysByAddBendSpringProduct) {
  look_at("goes-on");
  VectorXd dx = VectorXd::Zero(12);
  dx[11] = 1;
  for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
    expect_entries(product(kThree, kFirstMeets, term, dx), vector({0, 0, 0, 0, 0, 2.5, 0, 0, 0, 0, 0, -2.5}),
                   64 * kU * 5,
                   "the product at x = " + particles_in_words(kFirstMeets) +
                       ", where particles 0 and 2 meet and k = 2.5 N/m of the other spring, dx = " +
                       particles_in_words(dx),
                   "64 u of k (1 + d0/d): rounding");
}

int main(int argc, char** argv) {
  static const Strand lone = strand_of(VectorXd(0));
  static const VectorXd x = VectorXd::Zero(3);
  static VectorXd out = x;
  return run(argc, argv,
             {{"bend_spring_energy", [] { bend_spring_energy(lone, x); }},
              {"add_bend_spring_force", [] { add_bend_spring_force(lone, x, out); }, {"bend_spring_energy"}},
              {"add_bend_spring_product",
               [] { add_bend_spring_product(lone, x, GeometricTerm::full, x, out); },
               {"add_bend_spring_force"}}});
}
