// The elastica: how a straight elastic rod hangs that is clamped level and bends under its own weight, however far.
//
// With s the way along the rod from the clamp, over its length L, and theta the angle below level, the energy
//
//   E / (EI / L) = integral of theta'^2 / 2 - Gamma (1 - s) sin(theta) ds,     Gamma = rho g A L^3 / EI,
//
// is least where
//
//   theta'' = -Gamma (1 - s) cos(theta),   theta(0) = 0 (clamped),   theta'(1) = 0 (free).
//
// A rod that gives way along its axis, by W / EA at most (W its weight), is longer by 1 + (W / EA) (1 - s) sin(theta)
// at s: a load that is further out has that much more leverage, and the right side gets that factor.
//
// Seen from the tip, with t = 1 - s and psi = pi/2 - theta, the angle from the vertical, this is psi'' = Gamma t sin(psi), which
// grows from psi'(0) = 0 and one number that is not known, psi(0). It is found by shooting at psi(1) = pi/2. From
// the clamp no shot would arrive, for what grows there by exp(2/3 sqrt(Gamma)), 1e91 at Gamma = 1e5, is the error; from the
// tip it is the solution. So neither a graded mesh nor a continuation in Gamma is needed.
//
// Limits: the drop H of the tip over the width W of the curve is Gamma / 8 for small Gamma (a beam's deflection, rho g A
// L^4 / 8 EI), and sqrt(Gamma / 2) for large: there the rod hangs but for a boundary layer, psi'' = Gamma sin(psi), which is as
// wide as sqrt(2 / Gamma).
#pragma once

#include <Eigen/Core>
#include <limits>

namespace hair {

inline constexpr int kElasticaParts = 80;

struct Elastica {
  // Columns: where s = 0, 1 / kElasticaParts, ..., 1 is, over L: level, away from the clamp, and down.
  Eigen::Matrix2Xd points;
  double error = 0;  // of a point, estimated: from the same curve with twice the steps

  double width() const { return points(0, kElasticaParts); }  // of the tip, over L
  double drop() const { return points(1, kElasticaParts); }
};

// gamma > 0, at most 1e6; stretch = W / EA >= 0. Throws std::invalid_argument for others.
Elastica elastica(double gamma, double stretch = 0,
                  double segments = std::numeric_limits<double>::infinity());

}  // namespace hair
