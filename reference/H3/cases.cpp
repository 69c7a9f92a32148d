// STAFF ONLY. H3: hidden cases of bend_spring_energy, add_bend_spring_force and add_bend_spring_product.
// Bounds: grader/judge/cases/strand_springs.h.
#include <cmath>

#include "grader/judge/cases/strand_springs.h"
#include "hair/bend_springs.h"
#include "reference/H3/calls.h"

namespace grader::h3 {
namespace {

const Springs& springs() {
  static const Springs all = springs_of<Calls, hair::bend_spring_energy, hair::add_bend_spring_force,
                                        hair::add_bend_spring_product, &Strand::skip_rigidity, 2>();
  return all;
}

using Eigen::Vector3d;

// The force on the ends of one spring, and the energy, if this spring alone is longer than at rest, or has
// changed. The far end counts if no other spring begins there, since overwritten forces are for another
// category.
struct OfOneSpring {
  VectorXd force, product;
  double energy;
};

OfOneSpring of_spring(Trial& trial, const Strand& strand, const Vector3d& direction, int i) {
  const int count = strand.count();
  const Posed rest = straight_pose(strand, strand.rest_length, direction, "on a line");
  // Its second particle moves, and every second one behind it.
  VectorXd longer = VectorXd::Zero(3 * count);
  for (int j = i + 2; j < count; j += 2) longer.segment<3>(3 * j) = direction / 4;
  const Posed posed{strand, rest.x + longer, "spring " + std::to_string(i) + " longer"};
  const auto ends = [&](const VectorXd& of) {
    VectorXd both = VectorXd::Zero(6);
    both.head<3>() = of.segment<3>(3 * i);
    if (i + 4 >= count) both.tail<3>() = of.segment<3>(3 * i + 6);
    return both;
  };
  // The force at rest is subtracted, since the other springs' rest lengths are for another category.
  VectorXd force = springs().force(trial, posed);
  force -= springs().force(trial, rest);
  double energy = springs().energy(trial, posed);
  energy -= springs().energy(trial, rest);
  return {ends(force), ends(springs().product(trial, rest, longer)), energy};
}

}  // namespace

// Equal springs do the same at each place, in short strands and in long ones.
void every_spring(Trial& trial) {
  Random& random = trial.random;
  Strand strand = springs().metres(random, 3);
  const Vector3d direction = checks::ordinary_direction(random);
  const OfOneSpring alone = of_spring(trial, strand, direction, 0);
  const double k = strand.skip_rigidity;
  expect_not_zero(trial, alone.force, "the force of a strand of 3 particles");
  expect_not_zero(trial, alone.product, "the product of a strand of 3 particles");
  trial.expect(alone.energy > 0, "the energy of a strand of 3 particles is not positive");
  for (int count : {4, 7, 10000}) {
    strand = springs().metres(random, count);
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

void energy(Trial& trial) {
  energies_of_springs(trial, springs());
}

void forces(Trial& trial) {
  forces_of_springs(trial, springs());
}

void exact_product(Trial& trial) {
  exact_products_of_springs(trial, springs());
}

void filtered_product(Trial& trial) {
  filtered_products_of_springs(trial, springs());
}

void lengths(Trial& trial) {
  rest_lengths_of_springs(trial, springs());
  springs_in_other_units(trial, springs());
}

void added(Trial& trial) {
  added_by_springs(trial, springs());
}

void no_direction(Trial& trial) {
  springs_without_direction(trial, springs());
}

}  // namespace grader::h3
