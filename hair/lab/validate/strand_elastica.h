// The shape of a hanging strand with a horizontal clamp: the elastica, and the strand's deviation from it.
#pragma once

#include "hair/lab/validate/elastica.h"

namespace hair {

// True if segments are shorter than the boundary layer at the clamp: only then errors have an order.
bool has_an_order(double gamma, int segments);

// The ratio of the error's second term to its first. In the boundary layer at the clamp, 4 n^2 sinh^2(mu /
// 2n) = Gamma: the strand's decay rate is mu = sqrt(Gamma) (1 - q / 24 + 3 q^2 / 640 - ...), q = Gamma / n^2,
// so that the second term is 9/80 q of the first.
double next_term(double gamma, int segments);

struct StrandElastica {
  Eigen::Vector2d tip;   // over L, from the curve that a strand follows to fourth order
  double error = 0;      // its distance from the rod's tip
  double tolerance = 0;  // the largest allowed distance of a strand from `tip`
};

// Requires has_an_order(gamma, segments).
StrandElastica strand_elastica(double gamma, double stretch, int segments);

// For reports: the origin of the tolerance.
inline constexpr const char* kStrandElasticaTolerance =
    "the error's next term, 9/80 Gamma / n^2 of it, its stretch, and where Newton's method ends";

}  // namespace hair
