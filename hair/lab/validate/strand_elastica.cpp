#include "hair/lab/validate/strand_elastica.h"

#include <cmath>

namespace hair {

bool has_an_order(double gamma, int segments) {
  return segments >= 1.3 * std::sqrt(gamma);
}

double next_term(double gamma, int segments) {
  return 9.0 / 80 * gamma / (segments * segments);
}

StrandElastica strand_elastica(double gamma, double stretch, int segments) {
  const Eigen::Vector2d tip = elastica(gamma, stretch, segments).tip();
  const double error = (tip - elastica(gamma, stretch).tip()).norm();
  return {tip, error, error * (next_term(gamma, segments) + stretch) + 1e-12};
}

}  // namespace hair
