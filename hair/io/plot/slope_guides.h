// Where slope guides stand: in the free part of a plot, not far from what they are compared with.
#pragma once

#include <vector>

#include "hair/io/plot/axes.h"
#include "hair/io/plot/figure.h"
#include "hair/io/plot/scale.h"

namespace hair::plot {

// In pixels.
struct Spot {
  double x, y;
};

struct PlacedGuide {
  Spot from, to;
  Spot label;  // where its text begins, on the base line
};

// One for each guide, none of them outside of the box. `taken` is what they keep away from. The same input
// gives the same places.
std::vector<PlacedGuide> place_guides(const std::vector<SlopeGuide>& guides, const Box& box, const Scale& x,
                                      const Scale& y, const std::vector<Spot>& taken);

}  // namespace hair::plot
