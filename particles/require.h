// Preconditions of the given code: what is wrong, its value, and what would be right.
#pragma once

#include <sstream>
#include <stdexcept>

namespace particles {

// Throws std::invalid_argument("<what> is <value>; it <bound>") unless it holds. NaN holds for nothing that
// is compared.
inline void require(bool holds, const char* what, double value, const char* bound) {
  if (holds) return;
  std::ostringstream message;
  message.precision(17);
  message << what << " is " << value << "; it " << bound;
  throw std::invalid_argument(message.str());
}

}  // namespace particles
