// The box that a scene is seen in: found from its description alone, so that every run of it is seen from the
// same place.
#pragma once

#include "hair/render/camera.h"
#include "hair/scene/scene.h"

namespace hair {

// Where things start, where key frames take them, where hair hangs from its roots (as far below as it reaches
// at the start, and as far with the wind), and the other side of what swings. What nothing holds falls for as
// long as the scene lasts.
Bounds scene_bounds(const Scene& scene);

}  // namespace hair
