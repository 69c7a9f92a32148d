// Prevents tiny numbers from slowing a simulation down.
#pragma once

#include <cmath>

#include "particles/vectors.h"

namespace hair {

// A motion that comes to rest halves with each step or so, and ends in subnormal numbers (below 2^-1022), for
// which processors take ten times as long. This function sets such numbers to 0.
inline void drop_traces(particles::Output values) {
  for (double& value : values)
    if (std::abs(value) < 1e-150) value = 0;
}

}  // namespace hair
