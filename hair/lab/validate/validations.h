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
Validation double_pendulums(const ChainMethod& method);

// With bending: clamped hair as a beam, a rod and a curl.
Validation heavy_elastica();  // the curve itself, without any exercise
Validation hair_at_rest();    // compared with that curve
Validation beam_frequencies();
Validation beam_swing(Method method);  // H4, H6 or Runge-Kutta 4
Validation end_moment();
Validation buckling();
Validation elastica_in_motion(Method method);  // H4 or H6, as for those below
Validation buckling_in_motion(Method method);
Validation curl_at_rest(Method method);

}  // namespace hair
