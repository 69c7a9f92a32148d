// STAFF ONLY. How many times one curve's time another takes for the same error.
#pragma once

#include <optional>
#include <vector>

namespace grader {

// What a run with one number of steps gave.
struct Sample {
  double seconds = 0, error = 0;  // both > 0
};

// The median of theirs / ours over the errors that both reach, those of either curve; nothing if there are none. The
// time for an error is the least that any run takes which is as near or nearer, straight lines between runs in
// logarithms. Samples below `least_error` count as if they were there.
std::optional<double> time_ratio(const std::vector<Sample>& theirs, const std::vector<Sample>& ours,
                                 double least_error);

}  // namespace grader
