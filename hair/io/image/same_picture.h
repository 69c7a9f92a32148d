// Whether two pictures show the same geometry, though two machines drew them.
#pragma once

#include "hair/io/image/image.h"

namespace hair {

// Equal; or of the same size, at most 0.05 % of the pixels are off by more than 2 of 255 in a channel, and the
// root mean square over all channels is at most 0.5 of 255. The largest difference says nothing: at the edge of
// a strand, another machine's rounding turns one sample on or off.
bool same_on_another_machine(const Image& a, const Image& b);

}  // namespace hair
