// The parts of a toy that call an exercise.
#pragma once

#include "particles/toys/moving_toy.h"

namespace particles {

extern const ToyStep kToyForwardEuler, kToySymplecticEuler, kToyMidpoint, kToyRungeKutta4;
extern const ToyStep kToyImplicitEuler;
// The acceleration of a toy under its constraints. Keeps a reference to the toy.
std::unique_ptr<Dynamics> constrained_dynamics(MovingToy& moving, bool watched);

}  // namespace particles
