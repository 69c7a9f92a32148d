// STAFF ONLY. Asks a student's functions of H1, compares them with the reference, and bounds the rounding errors.
//
// Rounding. A segment's vector comes out of one subtraction, so that its length l has a relative error of a
// few u = 2^-53, wherever the strand is. What is compared has gone through less than 16 more operations in
// either program, hence 64 u of
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

#include "grader/suite/strand_trial.h"

namespace grader::h1 {

double ask_energy(Trial& trial, const Posed& posed);
VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before);
VectorXd ask_force(Trial& trial, const Posed& posed);  // starting from zeros
VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term = GeometricTerm::full);
VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx,
                     GeometricTerm term = GeometricTerm::full);

double energy_rounding(const Posed& posed);
double force_rounding(const Posed& posed);
double product_rounding(const Posed& posed, const VectorXd& dx);

// Compares the student's answers with the reference's, up to rounding.
void expect_energy(Trial& trial, const Posed& posed);
void expect_force(Trial& trial, const Posed& posed);
void expect_product(Trial& trial, const Posed& posed, GeometricTerm term);

inline constexpr Range kStretched = {1.05, 1.8}, kCompressed = {0.3, 0.95}, kMixed = {0.5, 1.6},
                       kToOnePercent = {0.01, 0.012}, kAnyBend = {0.1, 2.8};

}  // namespace grader::h1
