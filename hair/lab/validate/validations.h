// The functions that return the validations.
#pragma once

#include "hair/lab/validate/chain_methods.h"
#include "hair/lab/validate/validation.h"
#include "hair/simulation/simulation.h"

namespace hair {

// In published_numbers.cpp; calls no exercise.
Validation published_numbers();

// In curl_gives_way.cpp, which is compiled if the course has H8.
Validation curl_gives_way();

// They keep a reference to the method. In pendulum_period.cpp, then chain_oscillations.cpp.
Validation pendulum_period(const ChainMethod& method);
Validation chain_oscillations(const ChainMethod& method);

// With bending: clamped hair as a rod and as a beam.
Validation hair_at_rest();
Validation beam_frequencies();
Validation beam_swing(Method method);  // H4, H6 or Runge-Kutta 4
Validation buckling();

}  // namespace hair
