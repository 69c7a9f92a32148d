// The box that the camera shows. It depends only on the scene's description, so every run has the same
// camera.
#pragma once

#include "hair/render/camera.h"
#include "hair/scene/scene.h"

namespace hair {

// The box contains the start positions and their motion by key frames; hair hanging from its roots or blown
// by the wind; the circles of hair that starts too fast for its weight; the opposite side of torn hair; the
// mirrored side of swinging objects, which get no higher there; the whole wire of each bead; and the fall of
// unsupported objects over the scene's duration.
Bounds scene_bounds(const Scene& scene);

// Points of all objects: hair at its start, hanging and blown by the wind, and the surfaces of obstacles
// except the ground, each also at every key frame. Swinging hair may leave these points.
std::vector<Vector3d> scene_outline(const Scene& scene);

}  // namespace hair
