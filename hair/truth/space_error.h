// How far a strand of n segments is from the continuum: what its time error is not, and no smaller step takes away.
//
// Accurate motions of the strand divided anew, into b, 2b, 4b and 8b segments, are compared at the places that all of
// them have, the ends of the b segments, at all moments after the start. Two of them whose difference shrinks by 2^p
// when n doubles lead to the limit (L. F. Richardson, "The Approximate Arithmetical Solution by Finite Differences",
// Phil. Trans. Roy. Soc. A 210 (1911)):
//
//   x = x_8b + (x_8b - x_4b) / (2^p - 1),   p = log2(|x_4b - x_2b| / |x_8b - x_4b|).
//
// Segments are rigid where the strand has that limit and is no softer than hair: stretching moves hair by a millionth
// of its length, and space errors are thousands of times that. (Rigid, it takes a second; otherwise minutes.)
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "hair/truth/problem.h"

namespace hair {

struct SpaceLevel {
  int segments;
  double error;  // m, the largest distance from the limit, of any place at any moment
};

struct SpaceError {
  std::vector<SpaceLevel> levels;  // 4, one of them with the problem's own segments
  double order = 0;                // p; 2 in theory, of a smooth motion
  double time_error = 0;  // m, of the finest but one, by another tolerance: far below its space error
  double stretch = 0;     // m, what rigid segments leave out, about; 0 if they stretch
  double cpu_seconds = 0;

  // Why there is none, and then there are no levels: a toy, a strand that rests curved, no order in sight, ...
  std::string left_out = {};

  std::optional<double> error_of(int segments) const;  // m; none of segments that are no level
};

// Which strands are waited for: all, or those whose segments may be rigid, which take no more than seconds.
enum class Patience { seconds, minutes };

// Empty if `interrupted`. Where CVODE gives up, or forces throw, there is none either, and `left_out` says so.
std::optional<SpaceError> space_error(const Problem& problem, Patience patience,
                                      const std::atomic<bool>& interrupted);

}  // namespace hair
