// STAFF ONLY. H2: hidden cases of strands whose size or number is far from the ordinary. They compare the
// student's answers with each other, so that a mistake elsewhere does not count again.
#include "reference/H2/joints.h"

namespace grader::h2 {

using Eigen::Vector3d;

namespace {

// All answers keep their proportions in any size, from the thinnest cobweb to steel as long as a galaxy.
void other_units(Trial& trial) {
  Random& random = trial.random;
  Strand strand = even_strand(random, 7);
  strand.clamped = true;
  strand.root_tangent = checks::ordinary_direction(random);
  const Posed one = random_pose(random, strand, {1, 1}, {0.3, 1.4}, "a strand"),
              other = random_pose(random, strand, {1, 1}, {0.3, 1.4}, "another");
  // The contract's limits are 1e-100 and 1e100 m: 2^-332 and 2^332.
  expect_same_in_other_units(trial, strand_force(), one, other, {0x1p-320, 0x1p-40, 0x1p320});
}

// In a zigzag of 10,001 particles with equal joints each end behaves like that of a strand of 5.
void long_strand(Trial& trial) {
  Random& random = trial.random;
  const Vector3d direction = checks::ordinary_direction(random), aside = checks::ordinary_direction(random),
                 push = random_vector(random, 3);
  const double bend = random.uniform(0.5, 1);
  const Strand few = even_strand(random, 5);
  Strand many = even_strand(random, 10001);
  many.bend_rigidity = few.bend_rigidity;
  const Posed brief = zigzag(few, direction, aside, bend), lengthy = zigzag(many, direction, aside, bend);
  // Coordinates round by u of the strand's length; products divide by the sine, of 0.47 at least, twice.
  const double rounding = 512 * kUnit * few.bend_rigidity * many.count();
  expect_ends_alike(trial, strand_force(), brief, lengthy, 2, rounding, push);
}

}  // namespace

void extremes(Trial& trial) {
  other_units(trial);
  long_strand(trial);
}

}  // namespace grader::h2
