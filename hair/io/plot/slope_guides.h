// Places slope guides in the free part of a plot, near the data.
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
  Spot label;  // the start of its text, on the base line
};

// One for each guide, all inside the box and away from the points `taken`. The same input gives the same
// places.
std::vector<PlacedGuide> place_guides(const std::vector<SlopeGuide>& guides, const Box& box, const Scale& x,
                                      const Scale& y, std::vector<Spot> taken);

}  // namespace hair::plot
