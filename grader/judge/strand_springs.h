// STAFF ONLY. The springs of H1 and H3, which join each particle with the next one or the one after it: bounds of rounding errors, and
// hidden cases of what the geometric term does to products.
//
// Rounding. A spring's vector comes out of one subtraction, so that its length l has a relative error of a few u = 2^-53, wherever
// the strand is. What is compared has gone through less than 16 more operations in either program, hence 64 u of
//
//   k (l + l0)              N        for a spring's force
//   k (1 + l0/l) |de|       N        for its product with a change de
//   k |l - l0| (l + l0)     N m      for its energy, and u for each term of the sum
//
// A right energy may also be written k (l^2 - 2 l l0 + l0^2) / 2. Its terms cancel near l0: two products, a difference
// and a sum round by u of at most (l + l0)^2 each, and l^2 may be known without the rounding of l, 4 u of it. That is
// at most 8 u (l + l0)^2 k / 2, hence another
//
//   4 u k (l + l0)^2        N m      for its energy
//
// and twice that for an entry, where two springs meet.
#pragma once

#include <vector>

#include "grader/judge/strand_force.h"

namespace grader::inline judge {

struct Springs {
  double Strand::*rigidity;
  int apart;  // 1: each particle is joined with the next one. 2: with the one after it
};

double energy_rounding(const Springs& springs, const Posed& posed, double energy);
double force_rounding(const Springs& springs, const Posed& posed);
double product_rounding(const Springs& springs, const Posed& posed, const VectorXd& dx);

// The student's product with each term, and its rounding.
struct TermProduct {
  VectorXd (*ask)(Trial&, const Posed&, const VectorXd& dx, GeometricTerm);
  double (*rounding)(const Posed&, const VectorXd& dx);
};

// All springs of `longer` are longer than at rest: filtered, the product is the student's exact one. All of `shorter` are shorter:
// filtered, it is the one without the term.
void expect_filtered(Trial& trial, const TermProduct& product, const Posed& longer, const Posed& shorter,
                     const VectorXd& dx);

// On a line no spring turns if all move along it, and without the geometric term nothing else has a force.
void expect_along_a_line(Trial& trial, const TermProduct& product, const Posed& line,
                         const Eigen::Vector3d& direction, const VectorXd& dx);

// In a bent strand each spring has its own direction u: if its one end moves, what is left at the other one is the part along u.
void expect_own_directions(Trial& trial, const TermProduct& product, const Posed& bent, int apart);

// One of two springs is longer than at rest, and the other shorter: each has its own term. `moved` is an end of one alone.
void expect_own_term(Trial& trial, const TermProduct& product, const Posed& two, int moved, bool longer);

// An exercise's functions: the student's answers, and their comparison with the reference's, up to rounding.
template <class Calls, auto energy, auto add_force, auto add_product, double Strand::*rigidity, int apart>
struct SpringForce {
  static constexpr Springs kSprings{rigidity, apart};

  static double ask_energy(Trial& trial, const Posed& posed) {
    return energy_of<Calls, energy>(trial, posed);
  }
  static VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
    return sum_of<Calls, add_force>(trial, posed, "a force", before);
  }
  static VectorXd ask_force(Trial& trial, const Posed& posed) {
    return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
  }
  static VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx,
                              GeometricTerm term = GeometricTerm::full) {
    return sum_of<Calls, add_product>(trial, posed, "a product", VectorXd::Zero(dx.size()), term, dx);
  }

  static double energy_rounding(const Posed& posed) {
    return grader::energy_rounding(kSprings, posed, energy(posed.strand, posed.x));
  }
  static double force_rounding(const Posed& posed) { return grader::force_rounding(kSprings, posed); }
  static double product_rounding(const Posed& posed, const VectorXd& dx) {
    return grader::product_rounding(kSprings, posed, dx);
  }

  static VectorXd reference_force(const Posed& posed) {
    VectorXd f = VectorXd::Zero(posed.x.size());
    add_force(posed.strand, posed.x, f);
    return f;
  }
  static VectorXd reference_product(const Posed& posed, const VectorXd& dx, GeometricTerm term) {
    VectorXd df = VectorXd::Zero(dx.size());
    add_product(posed.strand, posed.x, term, dx, df);
    return df;
  }

  static void expect_energy(Trial& trial, const Posed& posed) {
    trial.expect_near(compared(ask_energy(trial, posed), energy(posed.strand, posed.x)),
                      energy_rounding(posed), "the error of the energy");
  }
  static void expect_force(Trial& trial, const Posed& posed) {
    expect_vector(trial, ask_force(trial, posed), reference_force(posed), force_rounding(posed), "the force");
  }
  static void expect_product(Trial& trial, const Posed& posed, const VectorXd& dx) {
    expect_vector(trial, ask_product(trial, posed, dx), reference_product(posed, dx, GeometricTerm::full),
                  product_rounding(posed, dx), "the product");
  }

  static constexpr TermProduct kProduct{ask_product, product_rounding};
  // With a product for each term.
  static StrandForce strand_force(const std::vector<GeometricTerm>& terms = {GeometricTerm::full}) {
    StrandForce all{ask_energy,      ask_force,      reference_force,  {},
                    energy_rounding, force_rounding, product_rounding, rigidity};
    for (const GeometricTerm term : terms)
      all.products.push_back(
          {[=](Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before) {
             return sum_of<Calls, add_product>(trial, posed, "a product", before, term, dx);
           },
           [=](const Posed& posed, const VectorXd& dx) { return reference_product(posed, dx, term); }});
    return all;
  }
};

}  // namespace grader::judge
