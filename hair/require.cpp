#include "hair/require.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "particles/require.h"

namespace hair {

void require(bool holds, const std::string& what, double value, const std::string& bound) {
  if (!holds) particles::require(false, what.c_str(), value, ("must be " + bound).c_str());
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

}  // namespace hair
