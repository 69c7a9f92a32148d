// The validations with bending: clamped hair as a beam, a rod and a curl.
#pragma once

#include <vector>

#include "hair/lab/validate/validation.h"
#include "hair/simulation/simulation.h"

namespace hair {

Validation heavy_elastica();  // the curve itself, without any exercise
Validation hair_at_rest();    // compared with that curve
Validation beam_frequencies();
Validation beam_swing(Method method);  // H4, H6 or Runge-Kutta 4
Validation end_moment();
Validation buckling();
Validation elastica_in_motion(Method method);  // H4 or H6, as for those below
Validation buckling_in_motion(Method method);
Validation curl_at_rest(Method method);

// All of the above.
std::vector<Validation> bending_validations();

}  // namespace hair
