// Checks of arguments: each throws std::invalid_argument, "<what> is <value>; it must be <bound>". NaN fails
// every check. A check that passes allocates no memory, so steps can use it too.
#pragma once

#include <string_view>

#include "particles/vectors.h"

namespace particles {

void require(bool holds, std::string_view what, double value, std::string_view bound);
void require_finite(std::string_view what, double value);
void require_positive(std::string_view what, double value);  // so large that 1 / value is finite
void require_at_least(std::string_view what, double value, double bound);  // also refuses infinities
void require_finite(std::string_view what, Input values);                  // checks each value
void require_direction(std::string_view what, const Vector3d& direction);  // requires length 1

}  // namespace particles
