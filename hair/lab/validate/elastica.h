// The elastica: the shape of a straight elastic rod that is clamped horizontally and bends under its own
// weight, with large deflections.
//
// Let s be the arc length from the clamp over the rod's length L, and theta the angle below horizontal. The
// energy
//
//   E / (EI / L) = integral of theta'^2 / 2 - Gamma (1 - s) sin(theta) ds,     Gamma = rho g A L^3 / EI,
//
// is least where
//
//   theta'' = -Gamma (1 - s) cos(theta),   theta(0) = 0 (clamped),   theta'(1) = 0 (free).
//
// A rod that stretches along its axis, by at most W / EA (W its weight), is longer by the factor 1 + (W / EA)
// (1 - s) sin(theta) at s. The load further out then has a longer lever arm, and the right side gets the same
// factor.
//
// Seen from the tip, with t = 1 - s and psi = pi/2 - theta, the angle from the vertical, this is psi'' =
// Gamma t sin(psi), with psi'(0) = 0 and one unknown number, psi(0). Shooting from the tip finds it, with the
// target psi(1) = pi/2. Shooting from the clamp would fail, because there the error grows by exp(2/3
// sqrt(Gamma)), 1e91 at Gamma = 1e5; from the tip the solution itself grows. So it needs neither a graded
// mesh nor a continuation in Gamma.
//
// Limits: the drop H of the tip over the width W of the curve is Gamma / 8 for small Gamma (a beam's
// deflection, rho g A L^4 / 8 EI), and sqrt(Gamma / 2) for large Gamma: then the rod hangs vertically except
// in a boundary layer, psi'' = Gamma sin(psi), of width sqrt(2 / Gamma).
#pragma once

#include <Eigen/Core>
#include <limits>

namespace hair {

struct Elastica {
  // Over L: horizontal distance from the clamp, and down.
  Eigen::Vector2d tip;
  double error = 0;  // its estimated error: from the same curve with half the steps, and the shot's miss
};

// gamma > 0, at most 1e6; stretch = W / EA from 0 to 1.
//
// With `segments` it is the curve on which a strand's particles lie, to fourth order in h = 1 / segments
// (backward error analysis; E. Hairer, C. Lubich and G. Wanner, "Geometric Numerical Integration", 2006,
// chapter IX). The strand's segments have the angles psi_j at their middles, its joints are springs, and its
// load lies on particles, so
//
//   (psi_{j+1} - 2 psi_j + psi_{j-1}) / h^2 = Gamma t_j sin(psi_j),
//   psi_{-1} = psi_0 at the tip,   (psi_{n-1} + psi_n) / 2 = pi/2 at the clamp, which bends half a segment,
//
// To fourth order this is psi'' + h^2/12 psi'''' = Gamma t sin(psi), with psi' = -h^2/24 psi''' at the tip
// and psi = pi/2 - h^2/8 psi'' at the clamp. The particles are sums over segments, the midpoint rule. Needs
// at least sqrt(Gamma) segments.
//
// Throws std::invalid_argument for arguments out of bounds.
Elastica elastica(double gamma, double stretch = 0,
                  double segments = std::numeric_limits<double>::infinity());

}  // namespace hair
