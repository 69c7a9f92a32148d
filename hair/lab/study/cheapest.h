// Which method gets to an error with the least CPU time.
#pragma once

#include <optional>
#include <vector>

#include "hair/lab/study/study.h"

namespace hair {

// The CPU time with which a method gets to an error, s: between two of its runs along the line that joins
// them in the diagram. From there on all finer runs are at least as good. None if it does not get there.
std::optional<double> time_for(const Sweep& sweep, Norm norm, double error);

struct Cost {
  int sweep;
  double seconds;
};

// Those that get there, the cheapest first.
std::vector<Cost> costs_for(const Study& study, Norm norm, double error);

}  // namespace hair
