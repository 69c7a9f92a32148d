// The path of a solver over the bowl phi(x) = x'Cx / 2 - f'x of two unknowns: its positions after 0, 1, 2,
// ... steps. As in a history, each place comes from a call of its own with that many steps. C is A, with f =
// b, or A'A, with f = A'b.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solver/study/history.h"
#include "solver/study/normal_digits.h"

namespace solver::study {

using Place = std::array<double, 2>;

struct BowlPath {
  std::string solver;         // "ConjGrad"
  double xx, xy, yy;          // C = [xx xy; xy yy]
  double condition;           // C's: the square of the ratio of the axes of its level sets
  Place bottom, begin;        // the solution, and f: the right first guess
  std::vector<Place> places;  // after 0, 1, 2, ... steps; the last ones may not be finite

  // phi(x) - phi(bottom), relative to the right first guess: 1 there, 0 at the bottom.
  double height(const Place& x) const;

  // The fewest steps to a height that only rounding explains; none if no place has such a height.
  std::optional<int> steps_to_bottom() const;
};

// Rounding leaves a height of at most (condition u)^2: for the two systems below about 1e-28.
inline constexpr double kBottomHeight = 1e-24;
inline constexpr int kMostPathSteps = 8;

// Two systems with the same solution and the same singular values, kSingular and 1 / kSingular. The first
// matrix is symmetric; the second one is not, and is solved by its normal equations. So the second bowl has
// the square of the first one's condition number.
inline constexpr double kSingular = 3;
BowlPath symmetric_path(const ConjGradFunction& solve);
BowlPath normal_path(const NormalEquationsFunction& solve);

}  // namespace solver::study
