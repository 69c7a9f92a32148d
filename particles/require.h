// Preconditions of what is given: each throws std::invalid_argument, "<what> is <value>; it must be <bound>". NaN holds
// for nothing that is compared.
#pragma once

#include <string>

namespace particles {

void require(bool holds, const std::string& what, double value, const std::string& bound);
void require_finite(const std::string& what, double value);
void require_positive(const std::string& what, double value);  // and normal: 1 / value is finite
void require_at_least(const std::string& what, double value, double bound);  // and finite

}  // namespace particles
