// Hints: wrong numbers often show clearly which mistake made them.
#pragma once

#include <span>
#include <string>

namespace checks {

enum class Looks {
  like_nothing,
  never_set,
  huge,
  tiny,
  no_number,
  zero,
  unchanged,
  filled,
  wrong_at_the_end,
  wrong_at_the_beginning,
  a_factor,
  transposed,
  wrong_signs
};

// The checks fill with this what a function overwrites.
inline constexpr double kFill = 1e3;

struct Hint {
  Looks looks = Looks::like_nothing;
  double number =
      0;  // of the entry that was never set, is huge, tiny or no number; of wrong entries at an end; or the factor
};

// Numbers that differ by no more than `bound` are the same. Both have the same length; each `block` numbers
// belong together: 3 are a particle's, 1 is an unknown's, 9 are a matrix' of 3 x 3. `before`, if given: an
// input, or what stood there before the call.
Hint find_hint(std::span<const double> actual, std::span<const double> expected, double bound, int block = 1,
               std::span<const double> before = {});

// As a sentence such as "-1 times what was expected: a sign?", or "" where nothing is clear.
std::string hint(std::span<const double> actual, std::span<const double> expected, double bound,
                 int block = 1, std::span<const double> before = {});

// The same for one number: 0, no number, or off by a sign. By chance one number is easily twice another:
// factors are told only of what is a plain `product`, such as an energy.
std::string hint_of_one(double actual, double expected, bool product);

}  // namespace checks
