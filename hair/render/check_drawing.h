// Rejects drawings that can't be drawn, before OpenGL sees them.
#pragma once

#include "hair/render/drawing.h"

namespace hair {

// Throws std::invalid_argument with the reason: a place that is not finite, such as a strand of H10 may have,
// or sizes that don't match their points.
void check_drawing(const Drawing& drawing);

}  // namespace hair
