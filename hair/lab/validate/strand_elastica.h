// How a strand hangs that is clamped level: as the elastica, and how far off that.
#pragma once

#include "hair/lab/validate/elastica.h"

namespace hair {

// Segments shorter than the layer at the clamp: from here on errors have an order.
bool has_an_order(double gamma, int segments);

// What an error's next term is, over the first. Down the layer at the clamp, 4 n^2 sinh^2(mu / 2n) = Gamma:
// the strand's decay is mu = sqrt(Gamma) (1 - q / 24 + 3 q^2 / 640 - ...), q = Gamma / n^2, and of that the
// second term is 9/80 q.
double next_term(double gamma, int segments);

struct StrandElastica {
  Eigen::Vector2d tip;   // over L, by the curve that a strand follows to fourth order
  double error = 0;      // how far that is from the rod's tip
  double tolerance = 0;  // how far a strand may be from it
};

// For has_an_order(gamma, segments).
StrandElastica strand_elastica(double gamma, double stretch, int segments);

// For reports: where the tolerance comes from.
inline constexpr const char* kStrandElasticaTolerance =
    "the error's next term, 9/80 Gamma / n^2 of it, its stretch, and where Newton's method ends";

}  // namespace hair
