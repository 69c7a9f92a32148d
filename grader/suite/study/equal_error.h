// STAFF ONLY. The ratio of two curves' times for the same error.
#pragma once

#include <optional>
#include <vector>

namespace grader {

// The result of a run with one number of steps.
struct Sample {
  double seconds = 0, error = 0;  // both > 0
};

// The median of theirs / ours over the errors of both curves' samples that both curves reach; nothing if
// there are none. The time for an error is the smallest time of a run with at most that error, with straight
// lines between runs in logarithmic axes. Samples below `least_error` count as if they had that error.
std::optional<double> time_ratio(const std::vector<Sample>& theirs, const std::vector<Sample>& ours,
                                 double least_error);

}  // namespace grader
