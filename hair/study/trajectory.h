// How a problem's particles moved: their state at each of its moments.
#pragma once

#include <vector>

#include "particles/state.h"

namespace hair {

// states[k] is at time duration * k / moments; states[0] is the start.
using Trajectory = std::vector<particles::State>;

}  // namespace hair
