// STAFF ONLY. H3: hidden cases of springs one by one and of springs without a length. They compare the student's
// answers with each other, so that a mistake elsewhere does not count again.
#include <cmath>

#include "reference/H3/springs.h"

namespace grader::h3 {

using Eigen::Vector3d;

namespace {

// One spring alone is longer than at rest, or has changed: the force on its ends, and the energy. The far end counts where no other
// spring begins: what overwrites its neighbours' forces is another category's.
struct OfOneSpring {
  VectorXd force, product;
  double energy;
};

OfOneSpring of_spring(Trial& trial, const Strand& strand, const Vector3d& direction, int i) {
  const int count = strand.count();
  const Posed rest = straight_pose(strand, strand.rest_length, direction, "on a line");
  // Its second particle, and every second one behind it.
  VectorXd longer = VectorXd::Zero(3 * count);
  for (int j = i + 2; j < count; j += 2) longer.segment<3>(3 * j) = direction / 4;
  const Posed posed{strand, rest.x + longer, "spring " + std::to_string(i) + " longer"};
  const auto ends = [&](const VectorXd& of) {
    VectorXd both = VectorXd::Zero(6);
    both.head<3>() = of.segment<3>(3 * i);
    if (i + 4 >= count) both.tail<3>() = of.segment<3>(3 * i + 6);
    return both;
  };
  return {ends(Bend::ask_force(trial, posed)), ends(Bend::ask_product(trial, rest, longer)),
          Bend::ask_energy(trial, posed)};
}

}  // namespace

// Springs that are alike do the same, wherever they are, and in short strands and long ones.
void every_spring(Trial& trial) {
  Random& random = trial.random;
  Strand strand = half_metres(random, 3);
  const Vector3d direction = random_direction(random);
  const OfOneSpring alone = of_spring(trial, strand, direction, 0);
  const double k = strand.skip_rigidity;
  expect_not_zero(trial, alone.force, "the force of a strand of 3 particles");
  expect_not_zero(trial, alone.product, "the product of a strand of 3 particles");
  trial.expect(alone.energy > 0, "the energy of a strand of 3 particles is not positive");
  for (int count : {4, 7, 10000}) {
    strand = half_metres(random, count);
    strand.skip_rigidity = k;
    // Coordinates round by u of the strand's length, at most count / 2.
    const double rounding = 64 * kUnit * k * count;
    for (int i = 0; i + 2 < count; i += count > 100 && i > 1 && i + 4 < count ? count / 2 - 3 : 1) {
      const OfOneSpring one = of_spring(trial, strand, direction, i);
      const int ends = i + 4 >= count ? 6 : 3;
      expect_vector(trial, one.force.head(ends), alone.force.head(ends), rounding,
                    "the force of one spring of a strand");
      expect_vector(trial, one.product.head(ends), alone.product.head(ends), rounding,
                    "the product of one spring of a strand");
      trial.expect_at_most(std::abs(one.energy - alone.energy), rounding,
                           "the error of the energy of one spring of a strand");
    }
  }
}

void no_direction(Trial& trial) {
  Random& random = trial.random;
  for (int count : {1, 2}) {
    const Posed posed{toy_strand(random, count), random_vector(random, 3 * count), "too short"};
    const VectorXd dx = random_vector(random, 3 * count);
    trial.expect(Bend::ask_energy(trial, posed) == 0, "a strand of fewer than 3 particles has an energy");
    trial.expect(Bend::ask_force(trial, posed).isZero(0), "a strand of fewer than 3 particles has a force");
    trial.expect(Bend::ask_product(trial, posed, dx).isZero(0),
                 "a strand of fewer than 3 particles has a product");
  }
  constexpr GeometricTerm kTerms[] = {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped};
  // Particles i and i + 2 in the same place: folded; and all of them.
  for (int which : {0, 3, -1}) {
    Posed posed = random_pose(random, half_metres(random, 6), kStretch, kBend, "coincident particles");
    for (int i = 0; i < 6; ++i)
      if (which < 0 || i == which + 2)
        posed.x.segment<3>(3 * i) = Vector3d(posed.x.segment<3>(which < 0 ? 0 : 3 * which));
    const bool nothing = which < 0;
    const VectorXd f = Bend::ask_force(trial, posed), change = random_vector(random, posed.x.size());
    trial.expect(f.isZero(0) == nothing, "particles in the same place have a force, or others have none");
    for (GeometricTerm term : kTerms)
      trial.expect(Bend::ask_product(trial, posed, change, term).isZero(0) == nothing,
                   "particles in the same place have a product, or others have none");
  }
  // Two springs, of which one has no length: its ends belong to it alone.
  for (int which : {0, 1}) {
    Posed posed{half_metres(random, 4), random_vector(random, 12), "one of two springs without a length"};
    posed.x.segment<3>(3 * which + 6) = Vector3d(posed.x.segment<3>(3 * which));
    const VectorXd f = Bend::ask_force(trial, posed), dx = random_vector(random, 12);
    const auto nothing = [&](const VectorXd& v) {
      return v.segment<3>(3 * which).isZero(0) && v.segment<3>(3 * which + 6).isZero(0);
    };
    trial.expect(nothing(f), "a spring without a length has a force, beside one that has a length");
    for (GeometricTerm term : kTerms)
      trial.expect(nothing(Bend::ask_product(trial, posed, dx, term)),
                   "a spring without a length has a product, beside one that has a length");
  }
  // A length of 0 costs as much energy as twice the rest length.
  Posed none{half_metres(random, 3), VectorXd::Zero(9), "folded"}, twice = none;
  none.x.segment<3>(3) = twice.x.segment<3>(3) = random_vector(random, 3);
  twice.x.tail<3>() = 2 * random_direction(random);
  trial.expect_at_most(std::abs(Bend::ask_energy(trial, none) - Bend::ask_energy(trial, twice)),
                       Bend::energy_rounding(none) + Bend::energy_rounding(twice),
                       "the error of the energy of a spring without a length");
}

}  // namespace grader::h3
