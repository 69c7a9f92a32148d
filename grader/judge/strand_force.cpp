// STAFF ONLY. Hidden cases that H1, H2 and H3 share.
#include "grader/judge/strand_force.h"

#include <cmath>

namespace grader::inline judge {
namespace {

VectorXd ask_force(Trial& trial, const StrandForce& force, const Posed& posed) {
  return force.ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const StrandForce::Product& product, const Posed& posed,
                     const VectorXd& dx) {
  return product.ask(trial, posed, dx, VectorXd::Zero(dx.size()));
}

}  // namespace

void expect_same_in_other_units(Trial& trial, const StrandForce& force, const Posed& one, const Posed& other,
                                std::initializer_list<double> metres) {
  const VectorXd dx = random_vector(trial.random, one.x.size());
  const auto energies = [&](const Posed& first, const Posed& second) {
    return Eigen::Vector2d(force.ask_energy(trial, first), force.ask_energy(trial, second));
  };
  InUnits in_energy(trial, energies(one, other), force.energy_rounding(one) + force.energy_rounding(other),
                    "the energy in other units"),
      in_force(trial, ask_force(trial, force, one), force.force_rounding(one), "the force in other units");
  std::vector<InUnits> in_products;
  for (const StrandForce::Product& product : force.products)
    in_products.emplace_back(trial, ask_product(trial, product, one, dx), force.product_rounding(one, dx),
                             "the product in other units");

  const auto expect_in = [&](double metre, double newton) {
    const auto changed = [&](Posed posed) {
      posed.strand.*force.rigidity *= newton;
      posed.strand.rest_length *= metre;
      posed.x *= metre;
      posed.name += ", in other units";
      return posed;
    };
    const Posed there = changed(one);
    in_energy.expect(energies(there, changed(other)), metre, newton);
    in_force.expect(ask_force(trial, force, there), metre, newton);
    for (std::size_t i = 0; i < in_products.size(); ++i)
      in_products[i].expect(ask_product(trial, force.products[i], there, dx), metre, newton);
  };
  for (const double metre : metres) expect_in(metre, 1);
  for (const double newton : {0x1p-60, 0x1p40}) expect_in(1, newton);
}

void expect_ends_alike(Trial& trial, const StrandForce& force, const Posed& brief, const Posed& lengthy,
                       int ends, double rounding, const VectorXd& push) {
  const auto of_an_end = [&](const Posed& posed, bool tip) {
    const auto end = [&](const VectorXd& of) -> VectorXd { return tip ? of.tail<3>() : of.head<3>(); };
    VectorXd dx = VectorXd::Zero(posed.x.size());
    (tip ? dx.tail<3>() : dx.head<3>()) = push;
    VectorXd all(3 + 3 * force.products.size());
    all.head<3>() = end(ask_force(trial, force, posed));
    for (std::size_t i = 0; i < force.products.size(); ++i)
      all.segment<3>(3 * i + 3) = end(ask_product(trial, force.products[i], posed, dx));
    return all;
  };
  for (const bool tip : {false, true})
    expect_vector(trial, of_an_end(lengthy, tip), of_an_end(brief, tip), rounding * (1 + push.norm()),
                  "force and product at the end of a long strand");
  const double share = force.ask_energy(trial, brief) / (brief.strand.count() - ends);
  trial.expect_at_most(std::abs(force.ask_energy(trial, lengthy) / (lengthy.strand.count() - ends) - share),
                       rounding, "the error of a long strand's energy");
}

void expect_parts_alone(Trial& trial, const StrandForce& force, const Posed& posed, int in_front,
                        const VectorXd& dx, double energy, double energy_rounding) {
  const Posed front = part_of(posed, 0, in_front),
              behind = part_of(posed, in_front, posed.strand.count() - in_front);
  energy += force.ask_energy(trial, front) + force.ask_energy(trial, behind);
  trial.expect_at_most(std::abs(force.ask_energy(trial, posed) - energy),
                       2 * force.energy_rounding(posed) + energy_rounding,
                       "the error of the energy of a strand with a segment of length 0");
  VectorXd both(dx.size());
  both << ask_force(trial, force, front), ask_force(trial, force, behind);
  expect_vector(trial, ask_force(trial, force, posed), both, 2 * force.force_rounding(posed),
                "the force on a strand with a segment of length 0");
  for (const StrandForce::Product& product : force.products) {
    both << ask_product(trial, product, front, dx.head(front.x.size())),
        ask_product(trial, product, behind, dx.tail(behind.x.size()));
    expect_vector(trial, ask_product(trial, product, posed, dx), both, 2 * force.product_rounding(posed, dx),
                  "the product of a strand with a segment of length 0");
  }
}

void expect_own_rest_lengths(Trial& trial, const StrandForce& force, Posed strand, int count,
                             const std::string& springs) {
  for (double& l : strand.strand.rest_length) l = trial.random.uniform(0.3, 2);
  const VectorXd change = random_vector(trial.random, strand.x.size());
  const std::string uneven = " a strand with uneven rest lengths, beside those of its " + springs + " alone,";
  expect_sum_of_parts(
      trial, strand, count, 4 * force.force_rounding(strand),
      [&](const Posed& part, int) { return ask_force(trial, force, part); }, "the force on" + uneven);
  for (const StrandForce::Product& product : force.products)
    expect_sum_of_parts(
        trial, strand, count, 4 * force.product_rounding(strand, change),
        [&](const Posed& part, int first) {
          return ask_product(trial, product, part, change.segment(3 * first, part.x.size()));
        },
        "the product of" + uneven);
}

void expect_added(Trial& trial, const StrandForce& force, const Posed& posed, int sums) {
  const VectorXd dx = random_vector(trial.random, posed.x.size()),
                 before = random_vector(trial.random, posed.x.size());
  const auto bound = [&](const VectorXd& of) { return sums * kUnit * (largest(of) + largest(before)); };
  const VectorXd f = ask_force(trial, force, posed);
  expect_size(trial, f.norm(), force.reference_force(posed).norm(), "the force");
  expect_vector(trial, force.ask_force(trial, posed, before), f + before,
                bound(f) + force.force_rounding(posed), "the force that is added to what f held");
  for (const StrandForce::Product& product : force.products) {
    const VectorXd df = ask_product(trial, product, posed, dx);
    expect_size(trial, df.norm(), product.reference(posed, dx).norm(), "the product");
    expect_vector(trial, product.ask(trial, posed, dx, before), df + before,
                  bound(df) + force.product_rounding(posed, dx), "the product that is added to what df held");
  }
}

}  // namespace grader::judge
