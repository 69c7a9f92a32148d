#include "particles/require.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace particles {

void require(bool holds, const std::string& what, double value, const std::string& bound) {
  if (holds) return;
  std::ostringstream message;
  message.precision(17);
  message << what << " is " << value << "; it must be " << bound;
  throw std::invalid_argument(message.str());
}

void require_finite(const std::string& what, double value) {
  require(std::isfinite(value), what, value, "finite");
}

void require_positive(const std::string& what, double value) {
  require(std::isfinite(value) && value >= std::numeric_limits<double>::min(), what, value, "finite and > 0");
}

void require_at_least(const std::string& what, double value, double bound) {
  std::ostringstream text;
  text.precision(17);
  text << "finite and at least " << bound;
  require(std::isfinite(value) && value >= bound, what, value, text.str());
}

}  // namespace particles
