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
#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <string>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/validations.h"
#include "solver/dense_algebra.h"

namespace hair {

namespace {

struct Lean {
  double angle, by_gamma, slope;  // theta(1), its derivative by Gamma, theta'(1)
};

Lean lean(double gamma) {
  Lean sum{1, 0, 0};
  double term = 1;
  for (int k = 1; k < 40; ++k) {
    term *= -gamma / ((3 * k - 1) * 3 * k);
    sum.angle += term;
    sum.by_gamma += k * term / gamma;
    sum.slope += 3 * k * term;
  }
  return sum;
}

double greenhill_number() {
  double gamma = 8;
  for (int i = 0; i < 20; ++i) {
    const Lean at = lean(gamma);
    gamma -= at.angle / at.by_gamma;
  }
  return gamma;
}

// Gamma (1/20 + 3 / 40 p): 0.5155, relative.
double greenhill_error() {
  const double gamma = greenhill_number(), slope = lean(gamma).slope;
  return gamma * (1.0 / 20 + 3 / (40 * slope * slope));
}

// Standing hair at rest; each segment is compressed by the weight above its middle.
StrandStart standing_hair(const Material& material, int segments, double length) {
  StrandStart start = clamped_hair(material, segments, length, Vector3d::UnitZ());
  const Strand& strand = start.strand;
  double weight = kEarthGravity * strand.mass.sum();
  for (int i = 0; i < segments; ++i) {
    weight -= kEarthGravity * strand.mass[i];
    start.state.x[3 * i + 5] =
        start.state.x[3 * i + 2] + strand.rest_length[i] * (1 - weight / strand.stretch_rigidity);
  }
  return start;
}

// The smallest eigenvalue, N/m, of its sideways stiffness: it buckles if this is below 0.
double softest_stiffness(const StrandStart& standing) {
  const auto strand = under_gravity(standing, Vector3d(0, 0, -kEarthGravity));
  const Eigen::MatrixXd K = planar_stiffness(strand->force, standing.state.x);
  const int n = standing.strand.segments();
  // Each particle has two unknowns; this takes the horizontal one.
  const Eigen::MatrixXd sideways = K(Eigen::seqN(0, n, 2), Eigen::seqN(0, n, 2));
  return solver::symmetric_eigenvalues(sideways)[0];
}

// The zero of the softest stiffness: a secant from either side, with bisection where it does not converge.
// NaN if there is no zero from 6 to 9.
double critical_gamma(const Material& material, int segments) {
  const auto stiffness = [&](double gamma) {
    return softest_stiffness(standing_hair(material, segments, length_of(material, gamma)));
  };
  double low = 6, high = 9, at_low = stiffness(low), at_high = stiffness(high);
  if (!(at_low > 0) || !(at_high < 0)) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 60 && high - low > 1e-13 * high; ++i) {
    double middle = low + (high - low) * at_low / (at_low - at_high);
    if (i % 3 == 2) middle = (low + high) / 2;
    const double at_middle = stiffness(middle);
    (at_middle > 0 ? low : high) = middle;
    (at_middle > 0 ? at_low : at_high) = at_middle;
  }
  return (low + high) / 2;
}

}  // namespace

ValidationResult buckling(const ValidationSettings& settings) {
  ValidationResult result;
  const Material hair;
  const double exact = greenhill_number();
  result.checks.push_back({"number", "rho g A L^3 / EI of a rod that buckles", "A. G. Greenhill, 1881",
                           7.8373, exact, 5e-5, "half of the last published digit"});
  Table table{
      "Where standing hair buckles", {"segments", "Gamma", "height, m", "relative error", "order"}, {}};
  double last = 0;
  for (int segments : {10, 20, 40, 80}) {
    settings.go_on();
    const double gamma = critical_gamma(hair, segments), error = gamma / exact - 1;
    const double expected = -greenhill_error() / (segments * segments);
    const double stretch =
        hair.line_density() * kEarthGravity * length_of(hair, exact) / hair.stretch_rigidity();
    const std::string n = std::to_string(segments);
    const double shorter = 3 * stretch;
    result.checks.push_back({"n" + n + "-error", n + " segments: relative error of the critical Gamma",
                             "Rayleigh's quotient with the strand's energies (buckling.cpp)", expected, error,
                             expected * expected + shorter,
                             "the next term: about the square of this one; and W / EA of the height, cubed"});
    if (last != 0)
      result.checks.push_back(
          {"n" + n + "-order", n + " segments: order of convergence", "central differences", 2,
           std::log2(last / error), 1.1 * 4 * std::abs(expected) + 2 * shorter / std::abs(expected),
           "the error's next term: 3/4 of it at half as many segments, over log(2); and W / EA"});
    table.rows.push_back({n, printed("%.9g", gamma), printed("%.9g", length_of(hair, gamma)),
                          printed("%.9g", error), last == 0 ? "" : printed("%.4f", std::log2(last / error))});
    last = error;
  }
  result.tables = {table};
  return result;
}

}  // namespace hair
