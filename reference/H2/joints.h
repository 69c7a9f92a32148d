// STAFF ONLY. Compares H2's functions with the reference: a strand's joints, and bounds of the rounding
// errors.
//
// A segment's vector is one subtraction, so its direction has an error of a few u = 2^-53 at any place of the
// strand, and an angle phi an error of a few u at any size. Directions perpendicular to the bend come from u1
// x u2, of length s = sin(phi), with an error of u / s. Less than 16 more operations give 64 u; in an entry
// with three joints of two segments each, 512 u, of
//
//   k (phi + 64 u)          N m    for a joint's energy, and u for each term of the sum
//   k phi_max / l           N      for the force; near the fold, where s is inaccurate, divided by s
//   k phi_max / (l^2 s^2)   N/m    for products, in the formula with the largest rounding error
#pragma once

#include <vector>

#include "grader/judge/cases/strand_force.h"

namespace grader::h2 {

struct Joint {
  double stiffness, angle,
      arm;  // EI/l, phi, the shorter of the two segments (at a clamped root the first segment)
};

// The joints that have an angle.
std::vector<Joint> joints(const Posed& posed);

inline constexpr Range kStretch = {0.6, 1.5}, kBend = {0.1, 2.8};

double energy_rounding(const Posed& posed);
double force_rounding(const Posed& posed);
double product_rounding(const Posed& posed, const VectorXd& dx);

// The student's answers; `function` is one of the two products.
inline constexpr int kProduct = 2, kSpdProduct = 3;
double ask_energy(Trial& trial, const Posed& posed);
VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before);
VectorXd ask_force(Trial& trial, const Posed& posed);  // starting from zeros
VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     int function);
VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, int function = kProduct);

VectorXd reference_force(const Posed& posed);
VectorXd reference_product(const Posed& posed, const VectorXd& dx, int function);
VectorXd ask_spd(Trial& trial, const Posed& posed, const VectorXd& dx);

StrandForce strand_force();  // for the cases that H1 to H3 share

// A strand whose segments of 1 m turn by `bend` to one side and back, in the plane of `direction` and
// `aside`.
Posed zigzag(const Strand& strand, const Eigen::Vector3d& direction, const Eigen::Vector3d& aside,
             double bend);

// True if forces on particles add up to zero, but for `rounding`.
bool is_balanced(const VectorXd& forces, double rounding);

}  // namespace grader::h2
