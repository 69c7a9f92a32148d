// Where a simulation broke. A step that leaves a number that is not finite, or one that no hair has, ends the
// simulation: nothing is drawn or measured as if it had not happened.
#pragma once

#include "particles/state.h"

namespace hair {

// A part of a step, in the order in which they come.
enum class Stage {
  integration,    // P1: the step of an explicit method
  filter,         // H4; H6, steps 1 and 2: the implicit solve and the way that it moves the particles
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

// What no hair's particle has: to be this far from the origin, to move faster than light.
inline constexpr double kFarthest = 1e9;  // m
inline constexpr double kFastest = 3e8;   // m/s

// False for a state with such a number, or one that is not finite.
bool is_sound(const particles::State& state);

}  // namespace hair
