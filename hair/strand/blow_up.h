// The place where a simulation broke. A step that produces a number that is not finite, or impossible for
// hair, ends the simulation, so that the numbers are not drawn or measured as if they were valid.
#pragma once

#include <cmath>

#include "particles/state.h"
#include "particles/vectors.h"

namespace hair {

// The stages of a step, in their order.
enum class Stage {
  integration,    // P1: the step of an explicit method
  filter,         // H4; H6, steps 1 and 2: the implicit solve and the motion of the particles with its result
  correction,     // H6, steps 3 and 4: lengths and impulse
  second_filter,  // H6, step 5
  collision
};

const char* stage_name(Stage stage);

struct BlowUp {
  int strand = 0;  // counted from 0
  long step = 0;   // counted from 1
  Stage stage = Stage::integration;
};

// Bounds that no particle of hair can exceed: the distance from the origin, and the speed of light.
inline constexpr double kFarthest = 1e9;  // m
inline constexpr double kFastest = 3e8;   // m/s

// False if the state exceeds these bounds or has a number that is not finite.
bool is_sound(const particles::State& state);

// A motion that comes to rest halves with each step or so, and ends in subnormal numbers (below 2^-1022), for
// which processors take ten times as long. This function sets such numbers to 0.
inline void drop_traces(particles::Output values) {
  for (double& value : values)
    if (std::abs(value) < 1e-150) value = 0;
}

}  // namespace hair
