#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

#include "hair/io/plot/page.h"
#include "solver/decimal_point.h"

namespace hair {

namespace {

constexpr double kLargestInFull = 1e6, kSmallestInFull = 1e-3;

// "1.20e-05" and "1.00e+12" as "1.2e-5" and "1e12".
std::string shortened(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') != std::string::npos) mantissa.resize(mantissa.find_last_not_of('0') + 1);
  if (mantissa.back() == '.') mantissa.pop_back();
  return mantissa + "e" + std::to_string(std::stoi(text.substr(e + 1)));
}

std::string formatted(double value, std::chars_format format, int precision) {
  std::array<char, 64> text = {};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr};
}

}  // namespace

std::string to_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < kLargestInFull && (size >= 999.5 || value == std::round(value)))
    return formatted(value, std::chars_format::fixed, 0);
  const auto format =
      size >= kSmallestInFull && size < 1000 ? std::chars_format::general : std::chars_format::scientific;
  if (format == std::chars_format::general) return formatted(value, format, 3);
  return shortened(formatted(value, format, 2));
}

std::string printed(const char* format, double value) {
  std::array<char, 64> text = {};
  const solver::DecimalPoint point;
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string to_exact_text(double value) {
  if (!std::isfinite(value)) return to_text(value);
  std::array<char, 32> text = {};
  return shortened({text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr});
}

}  // namespace hair
