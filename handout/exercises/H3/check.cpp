// The public checks of H3. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/bend_springs.h.

#include "hair/bend_springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "check.h"
#include "springs.h"

using namespace checks;
using hair::GeometricTerm;
using hair::Strand;

namespace {

const Springs& springs() {
  static const Springs all{hair::bend_spring_energy,
                           hair::add_bend_spring_force,
                           hair::add_bend_spring_product,
                           {"bend_spring_energy", "add_bend_spring_force", "add_bend_spring_product"},
                           &Strand::skip_rigidity,
                           "skip_rigidity",
                           "d",
                           2};
  return all;
}

const Eigen::VectorXd kMetre = vector({0.5, 0.5});

}  // namespace

TEST(Energy, OfOneSpring) {
  springs().expect_energy(kMetre, {1.75, 0.875});
}

TEST(Energy, SumsAllSprings) {
  for (const int count : {4, 5, 8}) springs().expect_even_energy(springs().metres(count));
}

TEST(Energy, SeesStretchingAndHardlyBending) {
  const Strand strand = springs().strand_of(kMetre);
  EXPECT_NUMBER(bend_spring_energy(strand, vector({0, 0, 0, 0, 0, -0.505, 0, 0, -1.01})), 12 * 1e-4 / 2,
                1e-15)
      << "straight, stretched by 1 %: d - d0 = 0.01 m, k = 12 N/m; bound: rounding";
  // Both segments 0.5 m, a turn by 0.01: d = cos(0.005), d - d0 = -1.25e-5 m to fourth order.
  const double E = bend_spring_energy(
      strand, vector({0, 0, 0, 0, 0, -0.5, 0, 0.5 * std::sin(0.01), -0.5 - 0.5 * std::cos(0.01)}));
  const double multiplied_out = 4 * kU * 12 * (1 + 1) * (1 + 1) / 2;
  EXPECT_NUMBER(E, 12 * std::pow(2 * std::pow(std::sin(0.0025), 2), 2) / 2, 1e-9 * E + multiplied_out)
      << "bent by 0.01: the energy is of fourth order in the angle; bound: rounding of d, 8 u, over 1.25e-5, "
         "or "
         "of the terms of (d - d0)^2, if it is multiplied out";
}

TEST(Lengths, OfTheEnergy) {
  springs().expect_energy(vector({1.5, 2.5}), {7, 1.75});
  for (const int count : {3, 5, 8}) springs().expect_even_energy(Springs::bent(count, count).strand);
}

TEST(Forces, OfOneSpring) {
  springs().expect_force(kMetre, {1.75, 0.875});
}

TEST(Forces, IsMinusTheEnergysGradient) {
  springs().expect_gradient({3, 4, 8});
}

TEST(Forces, GivesNoNetForceOrTorque) {
  springs().expect_balance();
}

TEST(Lengths, OfTheForce) {
  springs().expect_force(vector({1.5, 2.5}), {7, 1.75});
  for (const int count : {3, 5, 8}) springs().expect_even_force(Springs::bent(count, count).strand);
}

TEST(EverySpring, OfALongStrand) {
  springs().expect_even_force(springs().metres(10000));
}

TEST(ExactProduct, OfOneSpring) {
  springs().expect_product(kMetre, {1.75, 0.875}, {GeometricTerm::full});
}

TEST(ExactProduct, IsTheForcesDerivative) {
  springs().expect_derivative({3, 4, 8});
}

TEST(ExactProduct, IsSymmetric) {
  springs().expect_symmetry();
}

TEST(FilteredProduct, LetsThroughWhatItIsToldTo) {
  springs().expect_product(kMetre, {1.75, 0.875}, {GeometricTerm::filtered, GeometricTerm::dropped});
}

TEST(FilteredProduct, WithoutTheNegativeTermIsNegativeSemidefinite) {
  springs().expect_own_directions();
  springs().expect_semidefinite();
}

TEST(Lengths, InAnyUnit) {
  springs().expect_any_unit();
}

TEST(Added, IsAddedToWhatIsThere) {
  springs().expect_all_added();
}

TEST(NoDirection, OfParticlesThatMeet) {
  springs().expect_energy(kMetre, {0});
  springs().expect_force(kMetre, {0});
  springs().expect_product(kMetre, {0}, Springs::kTerms);
}

TEST(NoDirection, OfFewerThanThreeParticlesIsZero) {
  EXPECT_NUMBER(bend_spring_energy(springs().strand_of(vector({})), vector({1, 2, 3})), 0, 0)
      << "one particle";
  EXPECT_NUMBER(bend_spring_energy(springs().strand_of(vector({1})), vector({1, 2, 3, 4, 5, 6})), 0, 0)
      << "two particles";
}

TEST(NoDirection, OfTheSpringsBehindOneWithoutLengthStays) {
  springs().expect_to_go_on();
}

int main(int argc, char** argv) {
  return run(argc, argv, springs().functions());
}
