// The guides of dense hair that no picture of a run shows: nobody needs to simulate them.
//
// A strand that is drawn is out of view for the whole run if a ball that holds it lies outside of one side of
// the view, in all poses of its root's motion: as far as its guides are long, half as much for what springs
// may stretch, and as wide as its wisp spreads. A guide is idle if each strand that is made of it is, or if
// there is none. Where links or strips couple guides, none is: each moves others. Nor is hair that is drawn
// as it is, whatever the camera sees: it is its own strand, and states are asked for.
#pragma once

#include <vector>

#include "hair/render/scene_drawing.h"

namespace hair {

// The scene's strands that need not be simulated, rising. drawing: of this scene.
std::vector<int> idle_guides(const Scene& scene, const SceneDrawing& drawing);

}  // namespace hair
