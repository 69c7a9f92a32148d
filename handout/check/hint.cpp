#include "hint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <vector>

namespace checks {
namespace {

using Numbers = std::span<const double>;

// Memory that nobody has set holds this: check.cpp has the sanitizers fill it so.
bool was_never_set(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits == 0xfefefefefefefefe;
}

// Sums and products of unset memory are as large: -5e303.
bool is_made_of_it(double value) {
  return std::isfinite(value) && std::abs(value) > 1e290;
}

// Unset memory on the stack often holds the rest of something else: 4.7e-310.
bool is_a_rest(double value) {
  return value != 0 && std::abs(value) < 1e-290;
}

constexpr const char* kZero =
    "0: never written, left out by a condition or a loop's bounds, cut off by a min or max, "
    "a factor that is 0, a term that is missing, or terms that cancel?";
constexpr const char* kInfinite = "infinite: a division by 0, or a variable that was never set?";
constexpr const char* kNoNumber =
    "no number: 0/0, the root of a negative number, or a variable that was never set?";
constexpr const char* kNeverSet = ": was it made from a variable that was never set, or read beyond an end?";

double dot(Numbers a, Numbers b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Hint no_number_in(Numbers actual) {
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const auto entry = static_cast<double>(i);
    if (was_never_set(actual[i])) return {Looks::never_set, entry};
    if (is_made_of_it(actual[i])) return {Looks::huge, entry};
    if (!std::isfinite(actual[i])) return {Looks::no_number, entry};
  }
  return {};
}

struct Blocks {
  std::vector<bool> right = {};
  std::ptrdiff_t telling = 0;  // right ones in which something else than 0 is expected
};

Blocks right_blocks(Numbers actual, Numbers expected, double bound, int block) {
  Blocks blocks;
  const auto size = static_cast<std::size_t>(block);
  for (std::size_t i = 0; i < actual.size(); i += size) {
    bool same = true, tells = false;
    for (std::size_t j = i; j < std::min(i + size, actual.size()); ++j) {
      same = same && std::abs(actual[j] - expected[j]) <= bound;
      tells = tells || std::abs(expected[j]) > bound;
    }
    blocks.right.push_back(same);
    blocks.telling += same && tells ? 1 : 0;
  }
  return blocks;
}

// A factor that a mistake in a formula makes: a sign, a half, a third, a unit.
bool is_plain(double factor) {
  const double size = std::max(std::abs(factor), 1 / std::abs(factor));
  for (const double plain : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 100.0, 1e3, 1e4, 1e6})
    if (std::abs(size / plain - 1) < 1e-4) return true;
  return false;
}

// This many numbers of different sizes are not by chance the same multiple of others. Three may be one
// vector.
constexpr std::size_t kManySizes = 4;

std::size_t sizes_in(Numbers numbers, double rounding) {
  std::vector<double> sizes;
  for (const double value : numbers)
    if (std::ranges::none_of(sizes,
                             [&](double size) { return std::abs(size - std::abs(value)) <= rounding; }))
      sizes.push_back(std::abs(value));
  return sizes.size();
}

// One factor for all numbers, if there is one: the best in the sense of least squares leaves no more than
// rounding.
Hint factor_of(Numbers actual, Numbers expected, double bound) {
  const double squared = dot(expected, expected);
  double largest = 0;
  std::size_t of_size = 0;  // numbers that are far from 0
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (const double value : expected) of_size += std::abs(value) > 1e-3 * largest ? 1 : 0;
  if (!(squared > 0) || !std::isfinite(squared) || of_size < 2)
    return {};  // one number alone always has a factor
  const double factor = dot(actual, expected) / squared;
  for (std::size_t i = 0; i < actual.size(); ++i)
    if (!(std::abs(actual[i] - factor * expected[i]) <= 2 * bound + 1e-6 * std::abs(factor) * largest))
      return {};
  if (!is_plain(factor) || std::abs(factor - 1) < 1e-3) return {};  // near 1 the values are only inexact
  const bool sign = std::abs(factor + 1) < 1e-4;
  return sign || sizes_in(expected, 1e-3 * largest) >= kManySizes ? Hint{Looks::a_factor, factor} : Hint{};
}

// The hint if all wrong blocks are at one end.
Hint end_of(const Blocks& blocks, int block) {
  const std::vector<bool>& right = blocks.right;
  const auto wrong = std::ranges::count(right, false);
  if (wrong == 0 || wrong >= blocks.telling) return {};
  const auto is_wrong = [](bool one) { return !one; };
  const bool at_end = std::all_of(right.end() - wrong, right.end(), is_wrong);
  if (!at_end && !std::all_of(right.begin(), right.begin() + wrong, is_wrong)) return {};
  return {at_end ? Looks::wrong_at_the_end : Looks::wrong_at_the_beginning,
          static_cast<double>(wrong * block)};
}

Hint signs_of(Numbers actual, Numbers expected, double bound) {
  bool differs = false;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    if (!(std::abs(std::abs(actual[i]) - std::abs(expected[i])) <= bound)) return {};
    differs = differs || std::abs(actual[i] - expected[i]) > bound;
  }
  if (!differs) return {};
  return actual.size() > 1 ? Hint{Looks::wrong_signs} : Hint{Looks::a_factor, -1};
}

// All wrong numbers still have their values from before the call: two or more, or all.
bool is_filled(Numbers actual, Numbers expected, double bound) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < actual.size(); ++i)
    if (!(std::abs(actual[i] - expected[i]) <= bound)) {
      if (actual[i] != kFill) return false;
      ++wrong;
    }
  return wrong > 1 || wrong == actual.size();
}

// Each block is a square matrix, or its transpose.
bool is_transposed(Numbers actual, Numbers expected, double bound, int block) {
  const int rows = static_cast<int>(std::lround(std::sqrt(block)));
  if (rows < 2 || rows * rows != block || actual.size() % static_cast<std::size_t>(block) != 0) return false;
  bool differs = false;
  for (std::size_t first = 0; first < actual.size(); first += static_cast<std::size_t>(block)) {
    bool same = true, turned = true;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < rows; ++j) {
        const double one = actual[first + i * rows + j];
        same = same && std::abs(one - expected[first + i * rows + j]) <= bound;
        turned = turned && std::abs(one - expected[first + j * rows + i]) <= bound;
      }
    if (!same && !turned) return false;
    differs = differs || !same;
  }
  return differs;
}

std::string number_text(double number) {
  std::ostringstream text;
  text.precision(4);
  text << number;
  return text.str();
}

std::string told_of(double factor) {
  return number_text(factor) +
         " times what was expected: " + (std::abs(factor + 1) < 1e-4 ? "a sign?" : "a factor?");
}

std::string bound_or_zero(Numbers wrong) {
  const bool zero = std::ranges::all_of(wrong, [](double value) { return value == 0; });
  return zero ? ", where 0 stands: never written, or a loop's bound?" : ": a loop's bound?";
}

}  // namespace

Hint find_hint(Numbers actual, Numbers expected, double bound, int block, Numbers before) {
  if (actual.size() != expected.size() || actual.empty() || block < 1) return {};
  for (const double value : expected)
    if (!std::isfinite(value) || is_made_of_it(value)) return {};
  if (const Hint found = no_number_in(actual); found.looks != Looks::like_nothing) return found;
  const auto is_zero = [](double value) { return value == 0; };
  if (std::ranges::all_of(actual, is_zero))
    return std::ranges::all_of(expected, is_zero) ? Hint{} : Hint{Looks::zero};
  if (std::ranges::equal(actual, before) && !std::ranges::equal(expected, before)) return {Looks::unchanged};
  if (is_filled(actual, expected, bound)) return {Looks::filled};
  if (is_transposed(actual, expected, bound, block)) return {Looks::transposed};
  for (std::size_t i = 0; i < actual.size(); ++i)
    if (is_a_rest(actual[i]) && std::abs(expected[i]) > bound) return {Looks::tiny, static_cast<double>(i)};
  if (const Hint found = end_of(right_blocks(actual, expected, bound, block), block);
      found.looks != Looks::like_nothing)
    return found;
  if (const Hint found = factor_of(actual, expected, bound); found.looks != Looks::like_nothing) return found;
  return signs_of(actual, expected, bound);
}

std::string hint(Numbers actual, Numbers expected, double bound, int block, Numbers before) {
  const Hint found = find_hint(actual, expected, bound, block, before);
  const std::string number = number_text(found.number);
  const std::string entries = found.number == 1 ? "entry" : number + " entries";
  const auto count = static_cast<std::size_t>(found.number);
  switch (found.looks) {
    case Looks::like_nothing:
      return "";
    case Looks::never_set:
      return "entry " + number + " was never set";
    case Looks::huge:
      return "entry " + number + " is huge" + kNeverSet;
    case Looks::tiny:
      return "entry " + number + " is tiny" + kNeverSet;
    case Looks::no_number:
      return "entry " + number + " is " +
             (std::isinf(actual[static_cast<std::size_t>(found.number)]) ? kInfinite : kNoNumber);
    case Looks::zero:
      return std::string("all of it is ") + kZero;
    case Looks::unchanged:
      return "the input, or the values from before, unchanged: never written, nothing done, or undone "
             "again?";
    case Looks::filled:
      return "wrong where 1000 stands, as before the call: never written?";
    case Looks::wrong_at_the_end:
      return "right but for the last " + entries + bound_or_zero(actual.last(count));
    case Looks::wrong_at_the_beginning:
      return "right but for the first " + entries + bound_or_zero(actual.first(count));
    case Looks::a_factor:
      return told_of(found.number);
    case Looks::transposed:
      return "the transpose of what was expected";
    case Looks::wrong_signs:
      return "right but for signs of some entries";
  }
  return "";
}

std::string hint_of_one(double actual, double expected, bool product) {
  if (was_never_set(actual)) return "it was never set";
  if (is_made_of_it(actual) && !is_made_of_it(expected)) return std::string("it is huge") + kNeverSet;
  if (std::isnan(actual)) return std::string("it is ") + kNoNumber;
  if (std::isinf(actual) && std::isfinite(expected)) return std::string("it is ") + kInfinite;
  if (actual == kFill && expected != kFill) return "it is 1000, as before the call: never written?";
  if (expected == 0 || !std::isfinite(expected)) return "";
  if (actual == 0) return std::string("it is ") + kZero;
  if (is_a_rest(actual) && !is_a_rest(expected)) return std::string("it is tiny") + kNeverSet;
  for (const double factor : {-1.0, 2.0, 0.5, 4.0, 0.25, -2.0, -0.5})
    if (std::abs(actual / expected - factor) < 1e-6) return product || factor == -1 ? told_of(factor) : "";
  return "";
}

}  // namespace checks
