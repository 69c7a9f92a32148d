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

// The checks fill outputs with this before a call, if the function must overwrite them.
inline constexpr double kFill = 1e3;

struct Hint {
  Looks looks = Looks::like_nothing;
  // The number of the entry that was never set, is huge, tiny or no number; or how many entries at an end are
  // wrong; or the factor.
  double number = 0;
};

// Numbers that differ by no more than `bound` are the same. Both have the same length; each `block` numbers
// belong together: 3 are a particle's, 1 is an unknown's, 9 are a matrix' of 3 x 3. `before`, if given, is an
// input, or the output's numbers before the call.
Hint find_hint(std::span<const double> actual, std::span<const double> expected, double bound, int block = 1,
               std::span<const double> before = {});

// The hint as a sentence, such as "-1 times what was expected: a sign?", or "" if nothing is clear.
std::string hint(std::span<const double> actual, std::span<const double> expected, double bound,
                 int block = 1, std::span<const double> before = {});

// The same for one number: 0, no number, or off by a sign. One number is easily twice another by chance, so
// this reports factors only for a plain `product`, such as an energy.
std::string hint_of_one(double actual, double expected, bool product);

}  // namespace checks
