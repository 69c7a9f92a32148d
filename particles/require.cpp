#include "particles/require.h"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

namespace particles {

void require(bool holds, std::string_view what, double value, std::string_view bound) {
  if (holds) return;
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message.precision(17);
  message << what << " is " << value << "; it must be " << bound;
  throw std::invalid_argument(message.str());
}

void require_finite(std::string_view what, double value) {
  require(std::isfinite(value), what, value, "finite");
}

void require_positive(std::string_view what, double value) {
  require(std::isfinite(value) && value >= std::numeric_limits<double>::min(), what, value, "finite and > 0");
}

void require_at_least(std::string_view what, double value, double bound) {
  if (std::isfinite(value) && value >= bound) return;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << "finite and at least " << bound;
  require(false, what, value, text.str());
}

void require_finite(std::string_view what, Input values) {
  for (const double value : values) require_finite(what, value);
}

void require_direction(std::string_view what, const Vector3d& direction) {
  if (std::abs(direction.norm() - 1) <= 1e-9) return;
  require(false, std::string(what) + ": its length", direction.norm(), "1");
}

}  // namespace particles
