// STAFF ONLY. Reads numbers in cells.
#include "grader/text/number.h"

#include <charconv>
#include <cmath>

#include "grader/text/letters.h"

namespace grader::inline text {

std::optional<double> number_in(const std::string& cell) {
  std::string digits = composed(cell);
  const std::size_t last = digits.find_last_of(".,");
  std::string plain;
  for (std::size_t i = 0; i < digits.size(); ++i)
    if (digits[i] != '.' && digits[i] != ',')
      plain += digits[i];
    else if (i == last)
      plain += '.';
  double value = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (plain.empty() || error != std::errc() || end != plain.data() + plain.size() || !std::isfinite(value))
    return {};
  return value;
}

}  // namespace grader::text
