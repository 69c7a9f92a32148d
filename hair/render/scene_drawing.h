// A scene as it is drawn: its strands, obstacles and toys wherever a state has them, and the camera that
// looks at it from the first frame to the last.
#pragma once

#include <vector>

#include "hair/render/camera.h"
#include "hair/render/drawing.h"
#include "hair/render/renderer.h"
#include "hair/scene/scene.h"
#include "particles/state.h"

namespace hair {

// A scene that says nothing of its look gets the default one.
class SceneDrawing {
 public:
  explicit SceneDrawing(const Scene& scene);  // refers to the scene, which must outlive it

  RenderSettings settings() const;
  const Camera& camera() const { return camera_; }  // scene_bounds.h says where

  // Of all particles' positions (strand after strand, then toy after toy) and of the obstacles where they are
  // then. Throws std::invalid_argument for a state of another size.
  //
  // Of a toy, springs and rods are tubes, particles balls and wires rings; cloth is a sheet.
  Drawing at(const particles::State& state, const std::vector<Obstacle>& obstacles) const;

 private:
  void add_toy(const Toy& toy, int toy_index, particles::Input x, Drawing& drawing) const;

  const Scene& scene_;
  Look look_;
  Camera camera_;
  double unit_;  // m: the height of what the picture shows
};

}  // namespace hair
