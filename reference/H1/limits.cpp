// STAFF ONLY. H1: hidden cases of segments without a length, and of sizes and numbers far from the ordinary. They compare the
// student's answers with each other, so that a mistake elsewhere does not count again.
#include <cmath>

#include "reference/H1/springs.h"

namespace grader::h1 {

using Eigen::Vector3d;

void no_direction(Trial& trial) {
  Random& random = trial.random;
  // A strand of one particle has no spring.
  const Posed lone{toy_strand(random, 1), random_vector(random, 3), "one particle"};
  const VectorXd push = random_vector(random, 3);
  trial.expect(Stretch::ask_energy(trial, lone) == 0, "a strand of one particle has an energy");
  trial.expect(Stretch::ask_force(trial, lone).isZero(0), "a strand of one particle has a force");
  trial.expect(Stretch::ask_product(trial, lone, push).isZero(0), "a strand of one particle has a product");

  constexpr int kCount = 6;
  const std::vector<GeometricTerm> terms = {GeometricTerm::full, GeometricTerm::filtered,
                                            GeometricTerm::dropped};
  Posed point{toy_strand(random, kCount), random_vector(random, 3).replicate(kCount, 1), "all in one place"};
  const VectorXd dx = random_vector(random, 3 * kCount);
  trial.expect(Stretch::ask_force(trial, point).isZero(0), "segments of length 0 have a force");
  for (GeometricTerm term : terms)
    trial.expect(Stretch::ask_product(trial, point, dx, term).isZero(0),
                 "segments of length 0 have a product");

  // One segment of length 0, at the root, in between, at the tip. The two parts beside it do what each does alone,
  // and it has the energy that it has at twice its rest length.
  for (int which : {0, 2, 4}) {
    Posed posed =
        random_pose(random, toy_strand(random, kCount), kMixed, kAnyBend, "two particles in one place");
    posed.x.segment<3>(3 * which + 3) = posed.x.segment<3>(3 * which);
    Posed twice = part_of(posed, which, 2);
    twice.x.tail<3>() += 2 * posed.strand.rest_length[which] * random_direction(random);
    expect_parts_alone(trial, Stretch::strand_force(terms), posed, which + 1, dx,
                       Stretch::ask_energy(trial, twice), Stretch::energy_rounding(twice));
  }
}

namespace {

// A strand as thick as an atom or as long as a planet, of cobweb or of steel: all answers keep their proportions.
void other_units(Trial& trial) {
  Random& random = trial.random;
  const Strand strand = toy_strand(random, 7);
  const Posed one = random_pose(random, strand, kMixed, kAnyBend, "a strand"),
              other = random_pose(random, strand, kMixed, kAnyBend, "another");
  expect_same_in_other_units(trial, Stretch::strand_force(), one, other, {0x1p-80, 0x1p-35, 0x1p40});
}

// 10,000 particles on a line, all segments alike: each end moves as that of a strand of 5 does.
void long_strand(Trial& trial) {
  constexpr int kFew = 5, kMany = 10000;
  Random& random = trial.random;
  const Strand few = toy_strand(random, kFew);
  Strand many = toy_strand(random, kMany);
  many.stretch_rigidity = few.stretch_rigidity;
  const Vector3d direction = random_direction(random), push = random_vector(random, 3);
  const double strain = random.uniform(0.3, 0.6);
  const Posed brief = straight_pose(few, (1 + strain) * few.rest_length, direction, "5 particles"),
              lengthy = straight_pose(many, (1 + strain) * many.rest_length, direction, "10,000 particles");
  // Their coordinates round by u of the longer strand's length.
  const double rounding = 64 * kUnit * few.stretch_rigidity * largest(lengthy.x);
  expect_ends_alike(trial, Stretch::strand_force({GeometricTerm::filtered}), brief, lengthy, 1, rounding,
                    push);
}

}  // namespace

void extremes(Trial& trial) {
  other_units(trial);
  long_strand(trial);
}

}  // namespace grader::h1
