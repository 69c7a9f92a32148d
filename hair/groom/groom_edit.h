// Changes whole grooms.
#pragma once

#include "hair/groom/groom.h"

namespace hair {

// Converts points and thicknesses to another unit.
void scale(Groom& groom, double factor);

// Keeps the first of every `every` strands.
void keep_every(Groom& groom, long every);

}  // namespace hair
