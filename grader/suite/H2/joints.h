// STAFF ONLY. H2's functions beside the reference's: a strand's joints, and how much rounding they may leave.
//
// A segment's vector comes out of one subtraction, so that its direction has an error of a few u = 2^-53
// wherever the strand is, and an angle phi one of a few u at any size. Directions perpendicular to the bend
// come from u1 x u2, of length s = sin(phi), and are known to u / s. Less than 16 more operations give 64 u,
// in an entry where three joints meet with two segments each 512 u, of
//
//   k (phi + 64 u)          N m    for a joint's energy, and u for each term of the sum
//   k phi_max / l           N      for the force; next to the fold, where s is lost, over s
//   k phi_max / (l^2 s^2)   N/m    for products, in the formula that rounds most
#pragma once

#include <vector>

#include "grader/suite/strand_trial.h"

namespace grader::h2 {

struct Joint {
  double stiffness, angle,
      arm;  // EI/l, phi, the shorter of the two segments; of a clamped root the first segment
};

// Those that have an angle.
std::vector<Joint> joints(const Posed& posed);

inline constexpr Range kStretch = {0.6, 1.5}, kBend = {0.1, 2.8};

double energy_rounding(const Posed& posed);
double force_rounding(const Posed& posed);
double product_rounding(const Posed& posed, const VectorXd& dx);

VectorXd reference_force(const Posed& posed);
VectorXd reference_product(const Posed& posed, const VectorXd& dx, int function);
VectorXd ask_spd(Trial& trial, const Posed& posed, const VectorXd& dx);

// The student's answers are the reference's, to rounding; a product's to `rounding_of_straight` (N/m) more.
void expect_energy(Trial& trial, const Posed& posed);
void expect_force(Trial& trial, const Posed& posed);
void expect_product(Trial& trial, const Posed& posed, int function, double rounding_of_straight = 0);

}  // namespace grader::h2
