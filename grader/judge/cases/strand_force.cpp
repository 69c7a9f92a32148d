// STAFF ONLY. Hidden cases that H1, H2 and H3 share.
#include "grader/judge/cases/strand_force.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace grader::inline judge {

void expect_energy(Trial& trial, const StrandForce& force, const Posed& posed) {
  trial.expect_near(compared(force.energy(trial, posed), force.reference_energy(posed)),
                    force.energy_rounding(posed), "the error of the energy");
}

namespace {

// Compares with the reference's answer. An answer that is off is compared with `share()` times it, too: the
// factor by which an answer of another category is off, which reports it. That answer may be missing.
void expect_or_share(Trial& trial, const VectorXd& actual, const VectorXd& expected, double rounding,
                     const std::function<double()>& share, const std::string& what) {
  if (largest(actual - expected) <= rounding) return;
  double factor = 1;
  trial.ask_aside([&] { factor = share(); });
  const bool is_shared =
      factor > 1e-3 && factor < 1e3 && largest(actual - factor * expected) < largest(actual - expected);
  if (!is_shared) factor = 1;
  // The share comes from one answer, which has a rounding of its own.
  expect_vector(trial, actual, factor * expected,
                is_shared ? 2 * factor * (rounding + 0x1p-40 * largest(expected)) : rounding, what);
}

// Makes a pose of the same strand in which no spring is at rest.
Posed twice_as_long(const Posed& posed) {
  Posed twice = posed;
  twice.x *= 2;
  return twice;
}

}  // namespace

void expect_force(Trial& trial, const StrandForce& force, const Posed& posed) {
  const auto share = [&] {
    const Posed twice = twice_as_long(posed);
    return force.energy(trial, twice) / force.reference_energy(twice);
  };
  expect_or_share(trial, force.force(trial, posed), force.reference_force(posed), force.force_rounding(posed),
                  share, "the force");
}

void expect_product(Trial& trial, const StrandForce& force, const StrandForce::Product& product,
                    const Posed& posed, const VectorXd& dx) {
  const auto share = [&] {
    const Posed twice = twice_as_long(posed);
    const VectorXd expected = force.reference_force(twice);
    return force.force(trial, twice).dot(expected) / expected.squaredNorm();
  };
  expect_or_share(trial, product.ask_from_zero(trial, posed, dx), product.reference(posed, dx),
                  force.product_rounding(posed, dx), share, "the product");
}

void expect_same_in_other_units(Trial& trial, const StrandForce& force, const Posed& one, const Posed& other,
                                std::initializer_list<double> metres) {
  const VectorXd dx = random_vector(trial.random, one.x.size());
  const auto energies = [&](const Posed& first, const Posed& second) {
    return Eigen::Vector2d{force.energy(trial, first), force.energy(trial, second)};  // in this order
  };
  InUnits in_energy(trial, energies(one, other), force.energy_rounding(one) + force.energy_rounding(other),
                    "the energy in other units"),
      in_force(trial, force.force(trial, one), force.force_rounding(one), "the force in other units");
  std::vector<InUnits> in_products;
  for (const StrandForce::Product& product : force.products)
    in_products.emplace_back(trial, product.ask_from_zero(trial, one, dx), force.product_rounding(one, dx),
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
    in_force.expect(force.force(trial, there), metre, newton);
    for (std::size_t i = 0; i < in_products.size(); ++i)
      in_products[i].expect(force.products[i].ask_from_zero(trial, there, dx), metre, newton);
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
    all.head<3>() = end(force.force(trial, posed));
    for (std::size_t i = 0; i < force.products.size(); ++i)
      all.segment<3>(3 * i + 3) = end(force.products[i].ask_from_zero(trial, posed, dx));
    return all;
  };
  const auto energy_of_a_spring = [&](const Posed& posed) {
    return force.energy(trial, posed) / (posed.strand.count() - ends);
  };
  const double of_brief = energy_of_a_spring(brief), share = energy_of_a_spring(lengthy) / of_brief;
  for (const bool tip : {false, true}) {
    const VectorXd expected = of_an_end(brief, tip);
    // An energy rounds by as much as a force.
    const double bound = rounding * (1 + push.norm() + largest(expected) / std::abs(of_brief));
    expect_vector(trial, of_an_end(lengthy, tip), share * expected, std::max(1.0, std::abs(share)) * bound,
                  "force and product at the end of a long strand, beside its energy,");
  }
}

void expect_parts_alone(Trial& trial, const StrandForce& force, const Posed& posed, int in_front,
                        const VectorXd& dx, double energy, double energy_rounding) {
  const Posed front = part_of(posed, 0, in_front),
              behind = part_of(posed, in_front, posed.strand.count() - in_front);
  energy += force.energy(trial, front);
  energy += force.energy(trial, behind);
  trial.expect_at_most(std::abs(force.energy(trial, posed) - energy),
                       2 * force.energy_rounding(posed) + energy_rounding,
                       "the error of the energy of a strand with a segment of length 0");
  VectorXd both(dx.size());
  both << force.force(trial, front), force.force(trial, behind);
  expect_vector(trial, force.force(trial, posed), both, 2 * force.force_rounding(posed),
                "the force on a strand with a segment of length 0");
  for (const StrandForce::Product& product : force.products) {
    both << product.ask_from_zero(trial, front, dx.head(front.x.size())),
        product.ask_from_zero(trial, behind, dx.tail(behind.x.size()));
    expect_vector(trial, product.ask_from_zero(trial, posed, dx), both, 2 * force.product_rounding(posed, dx),
                  "the product of a strand with a segment of length 0");
  }
}

void expect_own_rest_lengths(Trial& trial, const StrandForce& force, const Posed& uneven, int count) {
  const VectorXd change = random_vector(trial.random, uneven.x.size());
  Posed even = uneven;
  even.strand.rest_length.setConstant(uneven.strand.rest_length.mean());
  // `add` adds a part's answer, times a factor, to the sum of all particles; `first` is its first particle.
  using Add = std::function<void(const Posed& part, int first, double factor, VectorXd& sum)>;
  const auto expect = [&](const std::string& what, const auto& rounding, const Add& add) {
    const auto left_over = [&](const Posed& posed) {
      VectorXd rest = VectorXd::Zero(posed.x.size());
      add(posed, 0, 1, rest);
      for (int first = 0; first + count <= posed.strand.count(); ++first)
        add(part_of(posed, first, count), first, -1, rest);
      return rest;
    };
    // If parts do not add up even with equal rest lengths, another category reports it.
    if (largest(left_over(even)) <= 4 * rounding(even))
      expect_vector(trial, left_over(uneven), VectorXd::Zero(uneven.x.size()), 4 * rounding(uneven),
                    what + " a strand with uneven rest lengths, beside those of its parts alone,");
  };
  expect("the energy of", force.energy_rounding, [&](const Posed& part, int, double factor, VectorXd& sum) {
    sum[0] += factor * force.energy(trial, part);
  });
  expect("the force on", force.force_rounding,
         [&](const Posed& part, int first, double factor, VectorXd& sum) {
           sum.segment(3 * first, part.x.size()) += factor * force.force(trial, part);
         });
  for (const StrandForce::Product& product : force.products)
    expect(
        "the product of", [&](const Posed& posed) { return force.product_rounding(posed, change); },
        [&](const Posed& part, int first, double factor, VectorXd& sum) {
          const VectorXd of_part = change.segment(3 * first, part.x.size());
          sum.segment(3 * first, part.x.size()) += factor * product.ask_from_zero(trial, part, of_part);
        });
}

void expect_added(Trial& trial, const StrandForce& force, const Posed& posed, int sums) {
  const VectorXd dx = random_vector(trial.random, posed.x.size()),
                 before = random_vector(trial.random, posed.x.size());
  const auto bound = [&](const VectorXd& of) { return sums * kUnit * (largest(of) + largest(before)); };
  const VectorXd f = force.force(trial, posed);
  expect_size(trial, f.norm(), force.reference_force(posed).norm(), "the force");
  expect_vector(trial, force.ask_force(trial, posed, before), f + before,
                bound(f) + force.force_rounding(posed), "the force that is added to what f held");
  for (const StrandForce::Product& product : force.products) {
    const VectorXd df = product.ask_from_zero(trial, posed, dx);
    expect_size(trial, df.norm(), product.reference(posed, dx).norm(), "the product");
    expect_vector(trial, product.ask(trial, posed, dx, before), df + before,
                  bound(df) + force.product_rounding(posed, dx), "the product that is added to what df held");
  }
}

}  // namespace grader::judge
