// The elastica: how a straight elastic rod hangs that is clamped level and bends under its own weight,
// however far.
//
// With s the way along the rod from the clamp, over its length L, and theta the angle below level, the energy
//
//   E / (EI / L) = integral of theta'^2 / 2 - Gamma (1 - s) sin(theta) ds,     Gamma = rho g A L^3 / EI,
//
// is least where
//
//   theta'' = -Gamma (1 - s) cos(theta),   theta(0) = 0 (clamped),   theta'(1) = 0 (free).
//
// A rod that gives way along its axis, by W / EA at most (W its weight), is longer by 1 + (W / EA) (1 - s)
// sin(theta) at s: a load that is further out has that much more leverage, and the right side gets that
// factor.
//
// Seen from the tip, with t = 1 - s and psi = pi/2 - theta, the angle from the vertical, this is psi'' =
// Gamma t sin(psi), which grows from psi'(0) = 0 and one number that is not known, psi(0). It is found by
// shooting at psi(1) = pi/2. From the clamp no shot would arrive, for what grows there by exp(2/3
// sqrt(Gamma)), 1e91 at Gamma = 1e5, is the error; from the tip it is the solution. So neither a graded mesh
// nor a continuation in Gamma is needed.
//
// Limits: the drop H of the tip over the width W of the curve is Gamma / 8 for small Gamma (a beam's
// deflection, rho g A L^4 / 8 EI), and sqrt(Gamma / 2) for large: there the rod hangs but for a boundary
// layer, psi'' = Gamma sin(psi), which is as wide as sqrt(2 / Gamma).
#pragma once

#include <Eigen/Core>
#include <limits>

namespace hair {

inline constexpr int kElasticaParts = 80;

struct Elastica {
  // Columns: where s = 0, 1 / kElasticaParts, ..., 1 is, over L: level, away from the clamp, and down.
  Eigen::Matrix2Xd points;
  double error =
      0;  // of a point, over L, estimated: from the same curve with half the steps, and what the shot missed

  Eigen::Vector2d tip() const { return points.col(kElasticaParts); }
};

// gamma > 0, at most 1e6; stretch = W / EA from 0 to 1.
//
// With `segments` the curve is that on which a strand's particles lie, to fourth order in h = 1 / segments
// (backward error analysis; E. Hairer, C. Lubich and G. Wanner, "Geometric Numerical Integration", 2006,
// chapter IX). Its segments have the angles psi_j in their middles, its joints are springs, its load lies on
// particles, and so
//
//   (psi_{j+1} - 2 psi_j + psi_{j-1}) / h^2 = Gamma t_j sin(psi_j),
//   psi_{-1} = psi_0 at the tip,   (psi_{n-1} + psi_n) / 2 = pi/2 at the clamp, which bends half of a segment,
//
// which is, to fourth order, psi'' + h^2/12 psi'''' = Gamma t sin(psi), psi' = -h^2/24 psi''' at the tip and
// psi = pi/2 - h^2/8 psi'' at the clamp. Particles are sums over segments, the midpoint rule. At least
// sqrt(Gamma) segments.
//
// Throws std::invalid_argument for what is out of bounds.
Elastica elastica(double gamma, double stretch = 0,
                  double segments = std::numeric_limits<double>::infinity());

}  // namespace hair
