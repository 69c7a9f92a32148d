// Keeps numbers that fade away from slowing a simulation down.
#pragma once

#include <cmath>

#include "particles/vectors.h"

namespace hair {

// What comes to rest halves with each step or so, and ends in numbers so small (subnormal ones, below
// 2^-1022) that processors take ten times as long for them: they become 0.
inline void drop_traces(particles::Output values) {
  for (double& value : values)
    if (std::abs(value) < 1e-150) value = 0;
}

}  // namespace hair
