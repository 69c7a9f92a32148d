// The validations of all that bends: clamped hair as a beam, a rod and a curl.
#pragma once

#include <vector>

#include "hair/simulation.h"
#include "hair/validate/validation.h"

namespace hair {

Validation heavy_elastica();  // the curve itself; it needs no exercise
Validation hair_at_rest();    // beside that curve

// All of them.
std::vector<Validation> bending_validations();

}  // namespace hair
