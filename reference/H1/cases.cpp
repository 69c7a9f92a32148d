// STAFF ONLY. H1: hidden cases of stretch_energy, add_stretch_force and add_stretch_product. Bounds:
// grader/judge/cases/strand_springs.h.
#include "grader/judge/cases/strand_springs.h"
#include "hair/stretch_springs.h"
#include "reference/H1/calls.h"

namespace grader::h1 {
namespace {

const Springs& springs() {
  static const Springs all = springs_of<Calls, hair::stretch_energy, hair::add_stretch_force,
                                        hair::add_stretch_product, &Strand::stretch_rigidity, 1>();
  return all;
}

// In 10,000 particles on a line with equal segments each end behaves like that of a strand of 5.
void long_strand(Trial& trial) {
  Random& random = trial.random;
  const Strand few = even_strand(random, 5);
  Strand many = even_strand(random, 10000);
  many.stretch_rigidity = few.stretch_rigidity;
  const Eigen::Vector3d direction = checks::ordinary_direction(random);
  const VectorXd push = random_vector(random, 3);
  const double strain = random.uniform(0.3, 0.6);
  const Posed brief = straight_pose(few, (1 + strain) * few.rest_length, direction, "5 particles"),
              lengthy = straight_pose(many, (1 + strain) * many.rest_length, direction, "10,000 particles");
  // Coordinates round by u of the longer strand's length.
  const double rounding = 64 * kUnit * few.stretch_rigidity * largest(lengthy.x);
  StrandForce filtered = springs();
  filtered.products = {springs().products[static_cast<int>(GeometricTerm::filtered)]};
  expect_ends_alike(trial, filtered, brief, lengthy, 1, rounding, push);
}

}  // namespace

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

void sampling(Trial& trial) {
  rest_lengths_of_springs(trial, springs());
}

void added(Trial& trial) {
  added_by_springs(trial, springs());
}

void no_direction(Trial& trial) {
  springs_without_direction(trial, springs());
}

void extremes(Trial& trial) {
  springs_in_other_units(trial, springs());
  long_strand(trial);
}

}  // namespace grader::h1
