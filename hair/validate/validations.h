// The validations that there are: a function each.
#pragma once

#include "hair/validate/validation.h"

namespace hair {}  // namespace hair
