// STAFF ONLY. Hidden cases that H1, H2 and H3 share, whose headers promise the same of an energy, a force and
// products. They compare the student's answers with each other, so that a mistake elsewhere does not count
// again.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "grader/judge/strand_trial.h"

namespace grader::inline judge {

// An exercise's functions. Those of the student add to `before`; roundings bound how far right answers are
// from each other.
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

// Compare the student's answers with the reference's, up to rounding.
void expect_energy(Trial& trial, const StrandForce& force, const Posed& posed);
void expect_force(Trial& trial, const StrandForce& force, const Posed& posed);
void expect_product(Trial& trial, const StrandForce& force, const StrandForce::Product& product,
                    const Posed& posed, const VectorXd& dx);

// In units of `metres`, and with other rigidities, all answers keep their proportions.
void expect_same_in_other_units(Trial& trial, const StrandForce& force, const Posed& one, const Posed& other,
                                std::initializer_list<double> metres);

// Each end of a long strand does what the end of a short one does, which is alike. `ends`: the particles at
// the tip without a spring of their own.
void expect_ends_alike(Trial& trial, const StrandForce& force, const Posed& brief, const Posed& lengthy,
                       int ends, double rounding, const VectorXd& push);

// Two particles are in one place: what comes before them and after them, with `dx` each, does what it does
// alone. `energy` is the two's.
void expect_parts_alone(Trial& trial, const StrandForce& force, const Posed& posed, int in_front,
                        const VectorXd& dx, double energy = 0, double energy_rounding = 0);

// Each spring has rest lengths of its own: a strand answers as its parts of `count` neighbours do, whatever
// these are, if it does so where they are equal.
void expect_own_rest_lengths(Trial& trial, const StrandForce& force, const Posed& uneven, int count);

// Force and products are added to what is there; `sums` bounds how often an entry rounds.
void expect_added(Trial& trial, const StrandForce& force, const Posed& posed, int sums);

}  // namespace grader::judge
