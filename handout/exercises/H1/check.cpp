// The public checks of H1. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/stretch_springs.h.

#include "hair/stretch_springs.h"

#include <gtest/gtest.h>

#include "check.h"
#include "springs.h"

using namespace checks;
using hair::GeometricTerm;
using hair::Strand;

namespace {

const Springs& springs() {
  static const Springs all{hair::stretch_energy,
                           hair::add_stretch_force,
                           hair::add_stretch_product,
                           {"stretch_energy", "add_stretch_force", "add_stretch_product"},
                           &Strand::stretch_rigidity,
                           "EA",
                           "l",
                           1};
  return all;
}

const Eigen::VectorXd kMetre = vector({1});

}  // namespace

TEST(Energy, OfOneSpring) {
  springs().expect_energy(kMetre, {1.75, 0.875});
}

TEST(Sampling, OfTheEnergy) {
  springs().expect_energy(vector({2}), {3.5, 1.75});
}

TEST(Sampling, OfTheEnergyOfSegmentsThatDiffer) {
  for (const int count : {2, 4, 6, 8}) springs().expect_even_energy(Springs::bent(count, count).strand);
}

TEST(Forces, OfOneSpring) {
  springs().expect_force(kMetre, {1.75, 0.875});
}

TEST(Forces, IsMinusTheEnergysGradient) {
  springs().expect_gradient({2, 3, 7});
}

TEST(Forces, GivesNoNetForceOrTorque) {
  springs().expect_balance();
}

TEST(Sampling, OfTheForce) {
  springs().expect_force(vector({2}), {3.5, 1.75});
  for (const int count : {2, 4, 6, 8}) springs().expect_even_force(Springs::bent(count, count).strand);
}

TEST(ExactProduct, OfOneSpring) {
  springs().expect_product(kMetre, {1.75, 0.875}, {GeometricTerm::full});
}

TEST(ExactProduct, IsTheForcesDerivative) {
  springs().expect_derivative({2, 3, 7});
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

TEST(Added, IsAddedToWhatIsThere) {
  springs().expect_all_added();
}

TEST(NoDirection, OfASegmentWithoutLengthIsZero) {
  springs().expect_force(kMetre, {0});
  springs().expect_product(kMetre, {0}, Springs::kTerms);
}

TEST(NoDirection, OfASegmentWithoutLengthHasAnEnergy) {
  springs().expect_energy(kMetre, {0});
  EXPECT_NUMBER(stretch_energy(springs().strand_of(vector({})), vector({1, 2, 3})), 0, 0) << "one particle";
}

TEST(NoDirection, OfTheSegmentsBehindOneWithoutLengthStays) {
  springs().expect_to_go_on();
}

TEST(Extremes, InAnyUnit) {
  springs().expect_any_unit();
}

TEST(Extremes, OfALongStrand) {
  springs().expect_even_energy(springs().metres(10000));
  springs().expect_even_force(springs().metres(10000));
}

int main(int argc, char** argv) {
  return run(argc, argv, springs().functions());
}
