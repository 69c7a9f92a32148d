// What is done to whole grooms.
#pragma once

#include "hair/head/groom.h"

namespace hair {

// Points and thicknesses in another unit.
void scale(Groom& groom, double factor);

// Keeps the first of every so many strands.
void keep_every(Groom& groom, long every);

}  // namespace hair
