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

// What memory holds that nobody has set: check.cpp has the sanitizers fill it so.
bool was_never_set(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits == 0xfefefefefefefefe;
}

// Sums and products of that are as large: -5e303.
bool is_made_of_it(double value) {
  return std::isfinite(value) && std::abs(value) > 1e290;
}

double dot(Numbers a, Numbers b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

std::string told_of_what_is_no_number(Numbers actual) {
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const std::string where = "entry " + std::to_string(i);
    if (was_never_set(actual[i])) return where + " was never set";
    if (is_made_of_it(actual[i])) return where + " is huge: was it made from a variable that was never set?";
    if (!std::isfinite(actual[i]))
      return where + " is no number: 0/0, the root of a negative number, or a variable that was never set?";
  }
  return "";
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

std::string told_of(double factor) {
  std::ostringstream text;
  text.precision(4);
  text << factor << " times what was expected: " << (std::abs(factor + 1) < 1e-4 ? "a sign?" : "a factor?");
  return text.str();
}

// One factor for all numbers, if there is one: the best in the sense of least squares leaves no more than rounding.
std::string told_of_a_factor(Numbers actual, Numbers expected, double bound) {
  const double squared = dot(expected, expected);
  double largest = 0;
  std::size_t of_size = 0;  // numbers that are far from 0
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (const double value : expected) of_size += std::abs(value) > 1e-3 * largest ? 1 : 0;
  if (!(squared > 0) || !std::isfinite(squared) || of_size < 2)
    return "";  // of one number there is always a factor
  const double factor = dot(actual, expected) / squared;
  for (std::size_t i = 0; i < actual.size(); ++i)
    if (!(std::abs(actual[i] - factor * expected[i]) <= 2 * bound + 1e-6 * std::abs(factor) * largest))
      return "";
  if (std::abs(factor) < 1e-12 || std::abs(factor - 1) < 1e-3) return "";  // 1: not exact, that is all
  return told_of(factor);
}

// All blocks are right but some at one end.
std::string told_of_an_end(const Blocks& blocks, int block) {
  const std::vector<bool>& right = blocks.right;
  const auto wrong = std::ranges::count(right, false);
  if (wrong == 0 || wrong >= blocks.telling) return "";
  const auto is_wrong = [](bool one) { return !one; };
  const bool at_end = std::all_of(right.end() - wrong, right.end(), is_wrong);
  if (!at_end && !std::all_of(right.begin(), right.begin() + wrong, is_wrong)) return "";
  const auto entries = wrong * block;
  return std::string("right but for the ") + (at_end ? "last " : "first ") +
         (entries == 1 ? "entry" : std::to_string(entries) + " entries") + ": a loop's bound?";
}

std::string told_of_signs(Numbers actual, Numbers expected, double bound) {
  bool differs = false;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    if (!(std::abs(std::abs(actual[i]) - std::abs(expected[i])) <= bound)) return "";
    differs = differs || std::abs(actual[i] - expected[i]) > bound;
  }
  return differs && actual.size() > 1 ? "right but for signs of some entries" : "";
}

}  // namespace

std::string hint(Numbers actual, Numbers expected, double bound, int block) {
  if (actual.size() != expected.size() || actual.empty() || block < 1) return "";
  for (const double value : expected)
    if (!std::isfinite(value) || is_made_of_it(value)) return "";
  if (std::string told = told_of_what_is_no_number(actual); !told.empty()) return told;
  const auto is_zero = [](double value) { return value == 0; };
  if (std::ranges::all_of(actual, is_zero))
    return std::ranges::all_of(expected, is_zero)
               ? ""
               : "all of it is 0: is the result written, or added, at all?";
  if (std::string told = told_of_an_end(right_blocks(actual, expected, bound, block), block); !told.empty())
    return told;
  if (std::string told = told_of_a_factor(actual, expected, bound); !told.empty()) return told;
  return told_of_signs(actual, expected, bound);
}

std::string hint_of_ratio(double actual, double expected) {
  if (was_never_set(actual)) return "it was never set";
  if (is_made_of_it(actual) && !is_made_of_it(expected))
    return "it is huge: was it made from a variable that was never set?";
  if (std::isnan(actual))
    return "it is no number: 0/0, the root of a negative number, or a variable that was never set?";
  if (expected == 0 || !std::isfinite(actual) || !std::isfinite(expected)) return "";
  if (actual == 0) return "it is 0: is the result written, or returned, at all?";
  for (const double factor : {-1.0, 2.0, 0.5, 3.0, 1.0 / 3, 4.0, 0.25, -2.0, -0.5})
    if (std::abs(actual / expected - factor) < 1e-6) return told_of(factor);
  return "";
}

}  // namespace checks
