// The validations that there are: a function each.
#pragma once

#include "hair/validate/chain_methods.h"
#include "hair/validate/validation.h"

namespace hair {

// chain_oscillations.cpp. They keep a reference to the method.
Validation chain_oscillations(const ChainMethod& method);
Validation double_pendulums(const ChainMethod& method);

}  // namespace hair
