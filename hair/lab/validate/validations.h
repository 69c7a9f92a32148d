// The validations that there are: a function each.
#pragma once

#include "hair/lab/validate/chain_methods.h"
#include "hair/lab/validate/validation.h"

namespace hair {

// published_numbers.cpp, which calls no exercise
Validation published_numbers();

// Those with a method keep a reference to it. pendulum_period.cpp, then chain_oscillations.cpp
Validation pendulum_period(const ChainMethod& method);
Validation chain_oscillations(const ChainMethod& method);
Validation double_pendulums(const ChainMethod& method);

}  // namespace hair
