#include "hair/validate/validation.h"

#include <cmath>

namespace hair {

bool Check::holds() const {
  return std::isfinite(measured) && std::isfinite(expected) && std::abs(error()) <= tolerance;
}

void ValidationSettings::go_on() const {
  if (interrupted && *interrupted) throw Interrupted();
}

}  // namespace hair
