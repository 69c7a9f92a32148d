// The box that the camera shows. It depends only on the scene's description, so that every run has the same
// camera.
#pragma once

#include "hair/render/camera.h"
#include "hair/scene/scene.h"

namespace hair {

// The box contains the start positions and their motion by key frames; hair hanging from its roots or blown
// by the wind; the circles of hair that starts too fast for its weight; the other side of torn hair; the
// mirrored side of swinging objects, which get no higher there; the whole wire of each bead; and the fall of
// unsupported objects over the scene's duration.
Bounds scene_bounds(const Scene& scene);

// Points of what there is: hair where it starts, where it hangs and where the wind blows it, and the surfaces
// of obstacles; all of it also where each key frame takes it. The ground has none. Hair that swings may leave
// them.
std::vector<Vector3d> scene_outline(const Scene& scene);

}  // namespace hair
