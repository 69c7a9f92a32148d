// STAFF ONLY. The functions, bounds of rounding errors and hidden cases that H1 and H3 share. Their springs
// join each particle with the next one or the one after it.
//
// Rounding. A spring's vector comes out of one subtraction, so that its length l has a relative error of a
// few u = 2^-53, wherever the strand is. The compared numbers have less than 16 more operations in either
// program, hence 64 u of
//
//   k (l + l0)              N        for a spring's force
//   k (1 + l0/l) |de|       N        for its product with a change de
//   k |l - l0| (l + l0)     N m      for its energy, and u for each term of the sum
//
// A right energy may also be written k (l^2 - 2 l l0 + l0^2) / 2. Its terms cancel near l0: two products, a
// difference and a sum round by u of at most (l + l0)^2 each, and l^2 may be known without the rounding of l,
// 4 u of it. That is at most 8 u (l + l0)^2 k / 2, hence another
//
//   4 u k (l + l0)^2        N m      for its energy
//
// and twice that for an entry, where two springs meet.
#pragma once

#include "grader/judge/cases/strand_force.h"

namespace grader::inline judge {

// This has products with the full, the filtered and the dropped term.
struct Springs : StrandForce {
  int apart;  // 1: each particle is joined with the next one. 2: with the one after it

  VectorXd product(Trial& trial, const Posed& posed, const VectorXd& dx,
                   GeometricTerm term = GeometricTerm::full) const {
    return products[static_cast<int>(term)].ask_from_zero(trial, posed, dx);
  }
  // H2's cases use this part, too: its only product is the exact one.
  StrandForce exact() const;
  // Makes a strand with springs 1 m long at rest: another category tests how k depends on lengths.
  Strand metres(Random& random, int count) const;
};

// Return bounds; see above. `energy` is the reference's.
double energy_rounding(double Strand::*rigidity, int apart, const Posed& posed, double energy);
double force_rounding(double Strand::*rigidity, int apart, const Posed& posed);
double product_rounding(double Strand::*rigidity, int apart, const Posed& posed, const VectorXd& dx);

template <class Calls, auto energy, auto add_force, auto add_product, double Strand::*rigidity, int apart>
Springs springs_of() {
  Springs all{
      {energy_of<Calls, energy>,
       [](Trial& trial, const Posed& posed, const VectorXd& before) {
         return sum_of<Calls, add_force>(trial, posed, "a force", before);
       },
       [](const Posed& posed) { return energy(posed.strand, posed.x); },
       [](const Posed& posed) {
         VectorXd f = VectorXd::Zero(posed.x.size());
         add_force(posed.strand, posed.x, f);
         return f;
       },
       {},
       [](const Posed& posed) {
         return energy_rounding(rigidity, apart, posed, energy(posed.strand, posed.x));
       },
       [](const Posed& posed) { return force_rounding(rigidity, apart, posed); },
       [](const Posed& posed, const VectorXd& dx) { return product_rounding(rigidity, apart, posed, dx); },
       rigidity},
      apart};
  for (const GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
    all.products.push_back(
        {[=](Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before) {
           return sum_of<Calls, add_product>(trial, posed, "a product", before, term, dx);
         },
         [=](const Posed& posed, const VectorXd& dx) {
           VectorXd df = VectorXd::Zero(dx.size());
           add_product(posed.strand, posed.x, term, dx, df);
           return df;
         }});
  return all;
}

// Compares with the reference, up to rounding.
void energies_of_springs(Trial& trial, const Springs& springs);
void forces_of_springs(Trial& trial, const Springs& springs);
void exact_products_of_springs(Trial& trial, const Springs& springs);

// The following compare the student's answers with each other, so that a mistake elsewhere does not count
// again.
void filtered_products_of_springs(Trial& trial, const Springs& springs);
void rest_lengths_of_springs(Trial& trial, const Springs& springs);
void added_by_springs(Trial& trial, const Springs& springs);
void springs_without_direction(Trial& trial, const Springs& springs);
void springs_in_other_units(Trial& trial, const Springs& springs);

}  // namespace grader::judge
