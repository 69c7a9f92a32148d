// The distance between a strand of n segments and the continuum. It is separate from the time error: smaller
// steps do not reduce it.
//
// Accurate motions of the strand divided into b, 2b, 4b and 8b segments are compared at their common places,
// the ends of the b segments, at all moments after the start. If the difference of two of them shrinks by 2^p
// when n doubles, they give the limit (L. F. Richardson, "The Approximate Arithmetical Solution by Finite
// Differences", Phil. Trans. Roy. Soc. A 210 (1911)):
//
//   x = x_8b + (x_8b - x_4b) / (2^p - 1),   p = log2(|x_4b - x_2b| / |x_8b - x_4b|).
//
// The segments are rigid: stretching moves hair by a millionth of its length, and space errors are thousands
// of times larger. Softer strands, which would take minutes, have no such error here.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "hair/truth/problem.h"

namespace hair {

struct SpaceLevel {
  int segments;
  double error;  // m, the largest distance from the limit, over all places and moments
};

struct SpaceError {
  std::vector<SpaceLevel> levels;  // 4, one of them with the problem's own segments
  double order = 0;                // p; 2 in theory, for a smooth motion
  double time_error = 0;  // m, of the second finest, from another tolerance: far below its space error
  double stretch = 0;     // m, the approximate effect of rigid segments
  double cpu_seconds = 0;

  // The reason why there are no levels: a toy, soft or curved hair, no clear order, ...
  std::string left_out = {};

  std::optional<double> error_of(int segments) const;  // m; none for a number of segments that is not a level
};

// Empty if `interrupted`. If CVODE fails or forces throw, there are no levels, and `left_out` has the reason.
std::optional<SpaceError> space_error(const Problem& problem, const std::atomic<bool>& interrupted);

}  // namespace hair
