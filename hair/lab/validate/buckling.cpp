// The height at which standing hair buckles: from its stiffness, and from its motion.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hair/lab/validate/bending_validations.h"
#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/greenhill.h"

namespace hair {

namespace {

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

ValidationResult find_heights(const ValidationSettings& settings) {
  ValidationResult result;
  const Material hair;
  const double exact = greenhill_number();
  result.checks.push_back({"number", "rho g A L^3 / EI of a rod that buckles", "A. G. Greenhill, 1881",
                           7.8373, exact, 5e-5, "half of the last published digit"});
  Table table{
      "Where standing hair buckles", {"segments", "Gamma", "height, m", "relative error", "order"}, {}};
  Figure figure{"buckling",
                "Where standing hair buckles: error against segments",
                "A straight line of slope -2: order 2.",
                {"segments"},
                {"relative error of the critical Gamma"}};
  Series& series = figure.series.emplace_back(Series{"critical Gamma", {}});
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
                             "Rayleigh's quotient with the strand's energies (greenhill.h)", expected, error,
                             expected * expected + shorter,
                             "the next term: about the square of this one; and W / EA of the height, cubed"});
    if (last != 0)
      result.checks.push_back(
          {"n" + n + "-order", n + " segments: order of convergence", "central differences", 2,
           std::log2(last / error), 1.1 * 4 * std::abs(expected) + 2 * shorter / std::abs(expected),
           "the error's next term: 3/4 of it at half as many segments, over log(2); and W / EA"});
    table.rows.push_back({n, printed("%.9g", gamma), printed("%.9g", length_of(hair, gamma)),
                          printed("%.9g", error), last == 0 ? "" : printed("%.4f", std::log2(last / error))});
    series.points.push_back(error_point(segments, std::abs(error)));
    last = error;
  }
  figure.guides.push_back({-2, "order 2"});
  result.figures = {figure};
  result.tables = {table};
  return result;
}

}  // namespace

Validation buckling() {
  return {"buckling", "The height at which hair that stands gets soft", {"H1", "H2"}, find_heights};
}

}  // namespace hair
