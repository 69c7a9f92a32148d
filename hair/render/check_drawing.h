// What can't be drawn is refused before OpenGL sees it.
#pragma once

#include "hair/render/drawing.h"

namespace hair {

inline constexpr std::size_t kMostStrandPoints = 20'000'000, kMostRound = 100'000;

// Throws std::invalid_argument, which names what is wrong: a number that is not finite, a radius or width
// that is not positive, sizes that don't match their points, more than there is memory for.
void check_drawing(const Drawing& drawing);

}  // namespace hair
