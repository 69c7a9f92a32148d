// Which method reaches a given error with the least CPU time.
#pragma once

#include <optional>
#include <vector>

#include "hair/lab/study/study.h"

namespace hair {

// The CPU time that a method needs for an error, s: interpolated on the line between two of its runs in the
// diagram, such that all finer runs have at most this error. None if it does not reach the error.
std::optional<double> time_for(const Sweep& sweep, Norm norm, double error);

struct Cost {
  int sweep;
  double seconds;
};

// The methods that reach the error, the cheapest first.
std::vector<Cost> costs_for(const Study& study, Norm norm, double error);

}  // namespace hair
