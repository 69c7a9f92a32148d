// Checks the elastica itself, to which strands are compared: six digits of it that the assignment states, and
// its limits.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "hair/lab/validate/elastica.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

void check_stated(ValidationResult& result) {
  struct Tip {
    double gamma, width, drop;
  };
  const std::string source = "the assignment's numbers",
                    digits = "half of the last digit, and the curve's own error";
  for (const Tip& tip : {Tip{1, 0.991246, 0.123471}, {10, 0.656354, 0.700200}, {100, 0.159223, 0.937524}}) {
    const Elastica curve = elastica(tip.gamma);
    const std::string gamma = to_text(tip.gamma), shows = "Gamma = " + gamma + ", the tip: ";
    result.checks.push_back({"tip-" + gamma + "-width", shows + "x / L", source, tip.width, curve.tip()[0],
                             5e-7 + curve.error, digits});
    result.checks.push_back({"tip-" + gamma + "-drop", shows + "drop / L", source, tip.drop, curve.tip()[1],
                             5e-7 + curve.error, digits});
  }
}

double slope(double gamma) {
  const Elastica curve = elastica(gamma);
  return curve.tip()[1] / curve.tip()[0];
}

// For the limits see elastica.h; H is the tip's drop, W its x. In the boundary layer, with e = 1 /
// sqrt(Gamma),
//
//   H / L = 1 - e (2 - sqrt(2)) + ...,   W / L = e sqrt(2) + e^2 (pi/2 - sqrt(2) + 1) + ...:
//
// after multiplication by psi' the equation integrates once, and the lower load further down (1 - s
// instead of 1) subtracts e times the integral of 1 - cos(psi).
void check_limits(ValidationResult& result) {
  const double light = 0.01;
  result.checks.push_back(
      {"light", "Gamma = 0.01: H / W over Gamma / 8", "Euler and Bernoulli's beam, rho g A L^4 / 8 EI", 1,
       slope(light) / (light / 8), light * light / 30,
       "angles are Gamma / 6 at most, and what a beam leaves out is 7/6 of their square at most"});
  const double root2 = std::numbers::sqrt2;
  for (const double heavy : {1e4, 1e6}) {
    const double second = (2 - root2 + (std::numbers::pi / 2 - root2 + 1) / root2) / std::sqrt(heavy);
    result.checks.push_back(
        {"heavy-" + to_text(heavy), "Gamma = " + to_text(heavy) + ": H / W over sqrt(Gamma / 2)",
         "boundary layer at the clamp, two terms", 1 - second, slope(heavy) / std::sqrt(heavy / 2),
         second * second, "the third term: about the square of the second"});
  }
}

void check_accuracy(ValidationResult& result) {
  double error = 0;
  for (const double gamma : {0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5})
    error = std::max(error, elastica(gamma).error);
  result.checks.push_back({"accuracy", "Gamma = 0.1 to 1e5: the largest error of a point, over L",
                           "the same with half the steps, over 15 (order 4)", 0, error, 1e-8,
                           "what strands are compared with is to be better than any of them"});
}

Figure shapes() {
  Figure figure{
      "elastica-shapes",
      "How hair hangs that is clamped level",
      "The more it weighs for its stiffness, the more it hangs straight down, but for a layer at the clamp.",
      {"x / L", false},
      {"height / L", false}};
  for (const double gamma : {0.1, 1.0, 10.0, 100.0, 1e3, 1e5}) {
    Series& series = figure.series.emplace_back(Series{"Gamma = " + to_text(gamma), {}});
    series.marked = false;
    const Elastica curve = elastica(gamma);
    for (int i = 0; i <= kElasticaParts; ++i)
      series.points.push_back({curve.points(0, i), -curve.points(1, i)});
  }
  return figure;
}

ValidationResult check_elastica(const ValidationSettings&) {
  ValidationResult result;
  check_stated(result);
  check_limits(result);
  check_accuracy(result);
  result.figures.push_back(shapes());
  return result;
}

}  // namespace

Validation heavy_elastica() {
  return {"elastica-curve", "The heavy elastica itself, by shooting from its tip", {}, check_elastica};
}

}  // namespace hair
