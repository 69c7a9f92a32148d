// STAFF ONLY. H2: hidden cases of strands whose size or number is far from the ordinary. They compare the student's answers with
// each other, so that a mistake elsewhere does not count again.
#include <cmath>

#include "grader/exercise/H2/joints.h"
#include "grader/exercise/H2/limits.h"

namespace grader::h2 {

using Eigen::Vector3d;

namespace {

// As thin as nothing, or as long as a galaxy, of cobweb or of steel: all answers keep their proportions.
void other_units(Trial& trial) {
  Random& random = trial.random;
  Strand strand = toy_strand(random, 7);
  strand.clamped = true;
  strand.root_tangent = random_direction(random);
  const Posed one = random_pose(random, strand, {1, 1}, {0.3, 1.4}, "a strand"),
              other = random_pose(random, strand, {1, 1}, {0.3, 1.4}, "another");
  const VectorXd dx = random_vector(random, one.x.size());
  const auto energies = [&](const Posed& first, const Posed& second) {
    return Eigen::Vector2d(ask_energy(trial, first), ask_energy(trial, second));
  };
  InUnits energy(trial, energies(one, other), energy_rounding(one) + energy_rounding(other),
                 "the energy in other units"),
      force(trial, ask_force(trial, one), force_rounding(one), "the force in other units"),
      product(trial, ask_product(trial, one, dx), product_rounding(one, dx), "the product in other units"),
      spd(trial, ask_spd(trial, one, dx), product_rounding(one, dx), "the product in other units");
  // The contract's limits are 1e-100 and 1e100 m: 2^-332 and 2^332.
  for (auto [metre, stiffness] :
       {std::pair{0x1p-320, 1.0}, {0x1p-40, 1.0}, {0x1p320, 1.0}, {1.0, 0x1p-60}, {1.0, 0x1p40}}) {
    const auto changed = [metre = metre, stiffness = stiffness](Posed posed) {
      posed.strand.bend_rigidity *= stiffness;
      posed.strand.rest_length *= metre;
      posed.x *= metre;
      posed.name += ", in other units";
      return posed;
    };
    const Posed there = changed(one);
    energy.expect(energies(there, changed(other)), metre, stiffness);
    force.expect(ask_force(trial, there), metre, stiffness);
    product.expect(ask_product(trial, there, dx), metre, stiffness);
    spd.expect(ask_spd(trial, there, dx), metre, stiffness);
  }
}

// A zigzag of 10,001 particles, all joints alike: each end moves as that of a strand of 5 does.
void long_strand(Trial& trial) {
  Random& random = trial.random;
  const Vector3d direction = random_direction(random), aside = random_direction(random),
                 push = random_vector(random, 3);
  const double bend = random.uniform(0.5, 1);
  const Strand few = toy_strand(random, 5);
  Strand many = toy_strand(random, 10001);
  many.bend_rigidity = few.bend_rigidity;
  const Posed brief = zigzag(few, direction, aside, bend), lengthy = zigzag(many, direction, aside, bend);
  // Coordinates round by u of the strand's length; products divide by the sine, of 0.47 at least, twice.
  const double rounding = 512 * kUnit * few.bend_rigidity * many.count();
  const auto of_an_end = [&](const Posed& posed, bool tip) {
    const auto end = [&](const VectorXd& of) -> Vector3d { return tip ? of.tail<3>() : of.head<3>(); };
    VectorXd dx = VectorXd::Zero(posed.x.size()), all(9);
    (tip ? dx.tail<3>() : dx.head<3>()) = push;
    all << end(ask_force(trial, posed)), end(ask_product(trial, posed, dx)), end(ask_spd(trial, posed, dx));
    return all;
  };
  for (bool tip : {false, true})
    expect_vector(trial, of_an_end(lengthy, tip), of_an_end(brief, tip), rounding * (1 + push.norm()),
                  "force and products at the end of a long strand");
  const double share = ask_energy(trial, brief) / (few.count() - 2);
  trial.expect_at_most(std::abs(ask_energy(trial, lengthy) / (many.count() - 2) - share), rounding,
                       "the error of a long strand's energy");
}

}  // namespace

void extremes(Trial& trial) {
  other_units(trial);
  long_strand(trial);
}

}  // namespace grader::h2
