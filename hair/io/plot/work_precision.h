// Error against run time, for studies of methods, models and submissions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hair/io/plot/figure.h"

namespace hair {

// The result of a run with one number of steps.
struct Sample {
  double seconds = 0, error = 0;  // both > 0
};

// The time for an error, s: the smallest time of a run with at most that error, with straight lines between
// the best runs in logarithmic axes. Samples below `least_error` count as if they had that error. None if no
// run reaches the error.
std::optional<double> time_for(const std::vector<Sample>& samples, double error, double least_error);

// The median of theirs / ours over the errors of both curves' best samples that both curves reach; none if
// there are none.
std::optional<double> time_ratio(const std::vector<Sample>& theirs, const std::vector<Sample>& ours,
                                 double least_error);

// True if smaller steps no longer help: each of the last three halvings left at least 98 % of the error. A
// run that failed has an error that is not a number, and does not count as such a halving.
bool stalls(const std::vector<double>& errors);

// Adds a dashed line at a level of the error, as wide as the figure's points; nothing to a figure without
// points.
void add_level(Figure& figure, const std::string& name, double error);

}  // namespace hair
