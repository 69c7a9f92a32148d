// The parts of a toy that call an exercise: there if the course has it.
#pragma once

#include "particles/toys/moving_toy.h"

namespace particles {

extern const ToyStep kToyForwardEuler, kToySymplecticEuler, kToyMidpoint, kToyRungeKutta4;
extern const ToyStep kToyImplicitEuler;
// How a toy accelerates while its constraints hold. Refers to the toy.
std::unique_ptr<Dynamics> constrained_dynamics(MovingToy& moving);

}  // namespace particles
