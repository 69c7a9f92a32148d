// Compares two pictures: do they show the same geometry, even if two different machines drew them?
#pragma once

#include "hair/io/image/image.h"

namespace hair {

// True if they are equal; or if they have the same size, at most 0.05 % of the pixels differ by more than 2
// of 255 in a channel, and the root mean square over all channels is at most 0.5 of 255. The largest
// difference is not tested: at the edge of a strand, another machine's rounding turns one sample on or off.
bool same_on_another_machine(const Image& a, const Image& b);

}  // namespace hair
