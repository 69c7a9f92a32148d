// Rejects drawings that can't be drawn, before OpenGL sees them.
#pragma once

#include "hair/render/drawing.h"

namespace hair {

inline constexpr std::size_t kMostStrandPoints = 20'000'000, kMostRound = 100'000;

// Throws std::invalid_argument with the reason: a number that is not finite, a radius or width that is not
// positive, sizes that don't match their points, or more data than memory.
void check_drawing(const Drawing& drawing);

}  // namespace hair
