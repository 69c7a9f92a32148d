// STAFF ONLY. H1: hidden cases of segments without a length, and of sizes and numbers far from the ordinary. They compare the
// student's answers with each other, so that a mistake elsewhere does not count again.
#include "grader/exercise/H1/limits.h"

#include <cmath>

#include "grader/exercise/H1/springs.h"

namespace grader::h1 {

using Eigen::Vector3d;

void no_direction(Trial& trial) {
  Random& random = trial.random;
  // A strand of one particle has no spring.
  const Posed lone{toy_strand(random, 1), random_vector(random, 3), "one particle"};
  const VectorXd push = random_vector(random, 3);
  trial.expect(ask_energy(trial, lone) == 0, "a strand of one particle has an energy");
  trial.expect(ask_force(trial, lone).isZero(0), "a strand of one particle has a force");
  trial.expect(ask_product(trial, lone, push).isZero(0), "a strand of one particle has a product");

  constexpr int kCount = 6;
  constexpr GeometricTerm kTerms[] = {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped};
  Posed point{toy_strand(random, kCount), random_vector(random, 3).replicate(kCount, 1), "all in one place"};
  const VectorXd dx = random_vector(random, 3 * kCount);
  trial.expect(ask_force(trial, point).isZero(0), "segments of length 0 have a force");
  for (GeometricTerm term : kTerms)
    trial.expect(ask_product(trial, point, dx, term).isZero(0), "segments of length 0 have a product");

  // One segment of length 0, at the root, in between, at the tip. The two parts beside it do what each does alone,
  // and it has the energy that it has at twice its rest length.
  for (int which : {0, 2, 4}) {
    Posed posed =
        random_pose(random, toy_strand(random, kCount), kMixed, kAnyBend, "two particles in one place");
    posed.x.segment<3>(3 * which + 3) = posed.x.segment<3>(3 * which);
    const int behind = kCount - 1 - which;
    const Posed root = part_of(posed, 0, which + 1), tip = part_of(posed, which + 1, behind);
    Posed twice = part_of(posed, which, 2);
    twice.x.tail<3>() += 2 * posed.strand.rest_length[which] * random_direction(random);
    const double E = ask_energy(trial, root) + ask_energy(trial, tip) + ask_energy(trial, twice);
    trial.expect_at_most(std::abs(ask_energy(trial, posed) - E),
                         2 * energy_rounding(posed) + energy_rounding(twice),
                         "the error of the energy of a strand with a segment of length 0");
    VectorXd both(3 * kCount);
    both << ask_force(trial, root), ask_force(trial, tip);
    expect_vector(trial, ask_force(trial, posed), both, 2 * force_rounding(posed),
                  "the force on a strand with a segment of length 0");
    for (GeometricTerm term : kTerms) {
      both << ask_product(trial, root, dx.head(3 * which + 3), term),
          ask_product(trial, tip, dx.tail(3 * behind), term);
      expect_vector(trial, ask_product(trial, posed, dx, term), both, 2 * product_rounding(posed, dx),
                    "the product of a strand with a segment of length 0");
    }
  }
}

namespace {

// A strand as thick as an atom or as long as a planet, of cobweb or of steel: all answers keep their proportions.
void other_units(Trial& trial) {
  Random& random = trial.random;
  const Strand strand = toy_strand(random, 7);
  const Posed one = random_pose(random, strand, kMixed, kAnyBend, "a strand"),
              other = random_pose(random, strand, kMixed, kAnyBend, "another");
  const VectorXd dx = random_vector(random, one.x.size());
  const auto energies = [&](const Posed& first, const Posed& second) {
    return Eigen::Vector2d(ask_energy(trial, first), ask_energy(trial, second));
  };
  InUnits energy(trial, energies(one, other), energy_rounding(one) + energy_rounding(other),
                 "the energy in other units"),
      force(trial, ask_force(trial, one), force_rounding(one), "the force in other units"),
      product(trial, ask_product(trial, one, dx), product_rounding(one, dx), "the product in other units");
  for (auto [metre, newton] :
       {std::pair{0x1p-80, 1.0}, {0x1p-35, 1.0}, {0x1p40, 1.0}, {1.0, 0x1p-60}, {1.0, 0x1p40}}) {
    const auto changed = [metre = metre, newton = newton](Posed posed) {
      posed.strand.stretch_rigidity *= newton;
      posed.strand.rest_length *= metre;
      posed.x *= metre;
      posed.name += ", in other units";
      return posed;
    };
    const Posed tiny = changed(one);
    energy.expect(energies(tiny, changed(other)), metre, newton);
    force.expect(ask_force(trial, tiny), metre, newton);
    product.expect(ask_product(trial, tiny, dx), metre, newton);
  }
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
  const auto of_an_end = [&](const Posed& posed, bool tip) {
    VectorXd dx = VectorXd::Zero(posed.x.size());
    (tip ? dx.tail<3>() : dx.head<3>()) = push;
    const VectorXd f = ask_force(trial, posed), df = ask_product(trial, posed, dx, GeometricTerm::filtered);
    VectorXd at_the_end(6);
    at_the_end << (tip ? f.tail<3>() : f.head<3>()), (tip ? df.tail<3>() : df.head<3>());
    return at_the_end;
  };
  for (bool tip : {false, true})
    expect_vector(trial, of_an_end(lengthy, tip), of_an_end(brief, tip), rounding * (1 + push.norm()),
                  "force and product at the end of a long strand");
  const double share = ask_energy(trial, brief) / (kFew - 1);
  trial.expect_at_most(std::abs(ask_energy(trial, lengthy) / (kMany - 1) - share), rounding,
                       "the error of a long strand's energy");
}

}  // namespace

void extremes(Trial& trial) {
  other_units(trial);
  long_strand(trial);
}

}  // namespace grader::h1
