// STAFF ONLY. Writes points as text.
#include "grader/report/facts/text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace grader::inline report {
namespace {

// Keeps at most `most` decimals, and no trailing zeros.
std::string with_decimals(double value, int most) {
  std::array<char, 400> digits;
  const int length = std::snprintf(digits.data(), digits.size(), "%.*f", most, value);
  std::string text(digits.data(), static_cast<std::size_t>(length));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

std::string shown_points(double points) {
  return with_decimals(points, 2);
}

std::string short_points(double points) {
  return with_decimals(points, 1);
}

std::string shown_total(double points, double max_points) {
  return shown_points(points) +
         (max_points > 0 ? " of " + shown_points(max_points) + " points" : " points of extra credit");
}

double rounded_points(double points) {
  return std::round(points * 1e4) / 1e4;
}

}  // namespace grader::report
