// The box that a scene is seen in: found from its description alone, so that every run of it is seen from the
// same place.
#pragma once

#include "hair/render/camera.h"
#include "hair/scene/scene.h"

namespace hair {

// Where things start, and where key frames take them; where hair hangs from its roots, or goes with the wind;
// the other side of what swings, for it gets no higher there. What hangs on a wire is inside wherever its
// bead is, and what nothing holds, falls for as long as the scene lasts.
Bounds scene_bounds(const Scene& scene);

}  // namespace hair
