// Preconditions: each throws std::invalid_argument that says what was given and what would have been right.
#pragma once

#include <string>

namespace hair {

// "WHAT is VALUE; it must be BOUND"
void require(const std::string& what, double value, bool holds, const std::string& bound);

void require_finite(const std::string& what, double value);
void require_positive(const std::string& what, double value);  // and normal, so that 1 / value is finite
void require_at_least(const std::string& what, double value, double bound);  // and finite

}  // namespace hair
