#include "hair/lab/validate/validation.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace hair {

bool Check::holds() const {
  return std::isfinite(measured) && std::isfinite(expected) && std::abs(error()) <= tolerance;
}

std::string printed(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

Point error_point(double x, double error, std::string note) {
  return {x, error, std::move(note), !(error > 0 && std::isfinite(error))};
}

void ValidationSettings::go_on() const {
  if (interrupted && *interrupted) throw Interrupted();
}

}  // namespace hair
