#include "hair/require.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hair {

void require(const std::string& what, double value, bool holds, const std::string& bound) {
  if (holds) return;
  std::ostringstream message;
  message.precision(17);
  message << what << " is " << value << "; it must be " << bound;
  throw std::invalid_argument(message.str());
}

void require_finite(const std::string& what, double value) {
  require(what, value, std::isfinite(value), "finite");
}

void require_positive(const std::string& what, double value) {
  require(what, value, std::isfinite(value) && value >= std::numeric_limits<double>::min(), "finite and > 0");
}

void require_at_least(const std::string& what, double value, double bound) {
  std::ostringstream text;
  text.precision(17);
  text << "finite and at least " << bound;
  require(what, value, std::isfinite(value) && value >= bound, text.str());
}

}  // namespace hair
