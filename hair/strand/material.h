// The material of a hair. Every strand model takes its constants from here.
#pragma once

#include <numbers>

namespace hair {

// A homogeneous round fibre. The default is human hair (C. R. Robbins, "Chemical and Physical Behavior of
// Human Hair", 5th edition, 2012, chapter 9).
struct Material {
  double radius = 50e-6;         // m
  double density = 1300;         // kg/m^3
  double young_modulus = 3e9;    // Pa
  double shear_modulus = 1.1e9;  // Pa; not Young's modulus / 2(1 + nu): hair is anisotropic

  double area() const { return std::numbers::pi * radius * radius; }                      // A, m^2
  double line_density() const { return density * area(); }                                // kg/m
  double stretch_rigidity() const { return young_modulus * area(); }                      // EA, N
  double bend_rigidity() const { return young_modulus * area() * radius * radius / 4; }   // EI, N m^2
  double twist_rigidity() const { return shear_modulus * area() * radius * radius / 2; }  // GJ, N m^2
};

}  // namespace hair
