// Finds the guides of dense hair that no picture of a run shows, so that they need not be simulated.
//
// A drawn strand is out of view for the whole run if a ball that holds it lies outside of one side of the
// view, in all poses of its root's motion. The ball's radius is the guides' length, plus half as much for
// stretched springs, plus the width of the wisp. A guide is idle if all strands made of it are out of view.
// If links or strips couple guides, none is idle, because each moves others. Hair that is drawn itself is
// never idle, whatever the camera sees, because its states may be asked for.
#pragma once

#include <vector>

#include "hair/scene_drawing/scene_drawing.h"

namespace hair {

// The scene's strands that need not be simulated, ascending. drawing: of this scene.
std::vector<int> idle_guides(const Scene& scene, const SceneDrawing& drawing);

}  // namespace hair
