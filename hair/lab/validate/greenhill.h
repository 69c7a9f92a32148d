// The greatest height of standing hair: above a certain length it buckles under its own weight. Source: A. G.
// Greenhill, "Determination of the greatest height consistent with stability ...", Proc. Cambridge Phil. Soc.
// 4 (1881).
//
// For a clamped rod that leans by theta, with t the arc length from its free end over L: theta'' = -Gamma t
// theta, theta'(0) = 0, theta(1) = 0. It buckles at Gamma = rho g A L^3 / EI = 7.8373, the first zero of
//
//   theta(1) = sum over k of (-Gamma)^k / ((2 . 3) (5 . 6) ... ((3k - 1) 3k)),     theta(0) = 1.
//
// For a strand: Rayleigh's quotient of that shape, with sums over joints and segments instead of integrals,
// is
//
//   Gamma_n = Gamma (1 - Gamma (1/20 + 3 / 40 p) / n^2 + O(1/n^4)),   p = theta'(1)^2.
#pragma once

#include "hair/simulation/simulation.h"

namespace hair {

double greenhill_number();              // 7.8373...
double greenhill_error();               // Gamma (1/20 + 3 / 40 p): 0.5155, relative
double strand_greenhill(int segments);  // Gamma_n, without the 1/n^4 term

// Standing hair at rest; each segment is compressed by the weight above its middle.
StrandStart standing_hair(const Material& material, int segments, double length);

// The smallest eigenvalue, N/m, of its sideways stiffness: it buckles if this is below 0.
double softest_stiffness(const StrandStart& standing);

}  // namespace hair
