#include "hair/lab/validate/validation.h"

#include <cmath>
#include <utility>

namespace hair {

bool Check::holds() const {
  return std::isfinite(measured) && std::isfinite(expected) && std::abs(error()) <= tolerance;
}

Point error_point(double x, double error, std::string note) {
  return {x, error, std::move(note), !(error > 0 && std::isfinite(error))};
}

void ValidationSettings::go_on() const {
  if (interrupted && *interrupted) throw Interrupted();
}

}  // namespace hair
