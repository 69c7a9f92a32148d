// STAFF ONLY. Asks a student's functions of H3, compares them with the reference, and bounds the rounding errors.
//
// Rounding: as of H1's springs (H1/springs.h), and for an entry where two springs meet 128 u = 2^-46 of
//
//   k (d + d0)  N,     k (1 + d0/d) |de|  N,     k |d - d0| (d + d0)  N m,
//
// and for the energy 4 u k (d + d0)^2 more, since it may be written k (d^2 - 2 d d0 + d0^2) / 2.
#pragma once

#include "grader/suite/strand_trial.h"

namespace grader::h3 {

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

VectorXd reference_force(const Posed& posed);
VectorXd reference_product(const Posed& posed, const VectorXd& dx, GeometricTerm term);

// Compares the student's answers with the reference's, up to rounding.
void expect_energy(Trial& trial, const Posed& posed);
void expect_force(Trial& trial, const Posed& posed);
void expect_product(Trial& trial, const Posed& posed, GeometricTerm term);

// Springs whose rest length is 1 m: what k is made of is another category's.
Strand half_metres(Random& random, int count);

inline constexpr Range kStretch = {0.6, 1.5}, kLong = {2, 3}, kBend = {0.1, 2.2};

}  // namespace grader::h3
