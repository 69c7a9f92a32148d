// STAFF ONLY. Makes the filter of the eye's contrast sensitivity.
#include "grader/compare/contrast_sensitivity.h"

#include <cmath>
#include <numbers>

namespace grader::inline compare {
namespace {

using std::numbers::pi;

// Is a exp(-b f^2): in degrees a Gaussian, a sqrt(pi / b) exp(-pi^2 x^2 / b).
struct Term {
  double a, b;
};
constexpr Term achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow{34.1, 0.04},
    blue_yellow_2{13.5, 0.025};

double sigma_of(const Term& term) {  // in degrees
  return std::sqrt(term.b / 2) / pi;
}

Plane seen(const Plane& channel, const Term& term, double pixels_per_degree) {
  // All terms get three standard deviations of the widest one.
  const int radius = static_cast<int>(std::ceil(3 * sigma_of(blue_yellow) * pixels_per_degree));
  const Kernel kernel = gaussian(sigma_of(term) * pixels_per_degree, radius);
  return filtered(channel, kernel, kernel);
}

// A sum of two Gaussians is no product of a row and a column, but each of them is. The paper takes the factor
// sqrt(pi / b) of one dimension in two: there the integral of a term is a sqrt(b / pi), not a.
Plane seen_blue_yellow(const Plane& channel, double pixels_per_degree) {
  const auto integral = [](const Term& term) { return term.a * std::sqrt(term.b / pi); };
  const double share = integral(blue_yellow) / (integral(blue_yellow) + integral(blue_yellow_2));
  Plane sum = seen(channel, blue_yellow, pixels_per_degree);
  const Plane second = seen(channel, blue_yellow_2, pixels_per_degree);
  for (std::size_t i = 0; i < sum.values.size(); ++i)
    sum.values[i] = static_cast<float>(share * sum.values[i] + (1 - share) * second.values[i]);
  return sum;
}

}  // namespace

Plane seen(const Plane& channel, Opponent opponent, double pixels_per_degree) {
  switch (opponent) {
    case Opponent::achromatic:
      return seen(channel, achromatic, pixels_per_degree);
    case Opponent::red_green:
      return seen(channel, red_green, pixels_per_degree);
    case Opponent::blue_yellow:
      return seen_blue_yellow(channel, pixels_per_degree);
  }
  return channel;
}

}  // namespace grader::compare
