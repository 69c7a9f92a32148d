// STAFF ONLY. Hidden cases that H1, H2 and H3 share: their headers promise the same of an energy, a force and
// products. Cases compare the student's answers with each other, so that a mistake elsewhere does not count
// again.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "grader/judge/cases/strand_trial.h"

namespace grader::inline judge {

// Holds an exercise's functions. The student's functions add to `before`; roundings bound the differences of
// right answers.
struct StrandForce {
  struct Product {
    std::function<VectorXd(Trial&, const Posed&, const VectorXd& dx, const VectorXd& before)> ask;
    std::function<VectorXd(const Posed&, const VectorXd& dx)> reference;

    VectorXd ask_from_zero(Trial& trial, const Posed& posed, const VectorXd& dx) const {
      return ask(trial, posed, dx, VectorXd::Zero(dx.size()));
    }
  };

  double (*energy)(Trial&, const Posed&);
  VectorXd (*ask_force)(Trial&, const Posed&, const VectorXd& before);
  double (*reference_energy)(const Posed&);
  VectorXd (*reference_force)(const Posed&);
  std::vector<Product> products;
  double (*energy_rounding)(const Posed&);
  double (*force_rounding)(const Posed&);
  double (*product_rounding)(const Posed&, const VectorXd& dx);
  double Strand::*rigidity;

  VectorXd force(Trial& trial, const Posed& posed) const {
    return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
  }
};

// Compare the student's answers with the reference's, up to rounding. A force may be off by the factor by
// which the student's energy is, and a product by that of the student's force: one constant is one mistake.
void expect_energy(Trial& trial, const StrandForce& force, const Posed& posed);
void expect_force(Trial& trial, const StrandForce& force, const Posed& posed);
void expect_product(Trial& trial, const StrandForce& force, const StrandForce::Product& product,
                    const Posed& posed, const VectorXd& dx);

// All answers keep their proportions in units of `metres`, and with other rigidities.
void expect_same_in_other_units(Trial& trial, const StrandForce& force, const Posed& one, const Posed& other,
                                std::initializer_list<double> metres);

// Each end of a long strand must behave like the same end of a short one, in proportion to the energy of a
// spring. `ends` counts the particles at the tip without a spring of their own.
void expect_ends_alike(Trial& trial, const StrandForce& force, const Posed& brief, const Posed& lengthy,
                       int ends, double rounding, const VectorXd& push);

// Two particles coincide: the parts before and after them, with `dx` each, must behave as they do alone.
// `energy` is that of the two particles.
void expect_parts_alone(Trial& trial, const StrandForce& force, const Posed& posed, int in_front,
                        const VectorXd& dx, double energy = 0, double energy_rounding = 0);

// Each spring has rest lengths of its own: a strand answers like the sum of its parts of `count` neighbours,
// if it does so with equal rest lengths.
void expect_own_rest_lengths(Trial& trial, const StrandForce& force, const Posed& uneven, int count);

// Force and products are added to the buffer's content; `sums` bounds how often an entry rounds.
void expect_added(Trial& trial, const StrandForce& force, const Posed& posed, int sums);

}  // namespace grader::judge
