// Pictures of a scene while it plays. What draws them is loaded when this is made, and not before.
#pragma once

#include "hair/render/renderer.h"
#include "hair/render/scene_drawing.h"
#include "hair/scene/playback.h"
#include "hair/scene/scene.h"

namespace hair {

class Pictures {
 public:
  // Of a scene that has a look, and outlives this. Throws NoOpenGl.
  explicit Pictures(const Scene& scene);

  Image draw(const particles::State& state, const std::vector<Obstacle>& obstacles);

  const RenderTimes& times() const { return renderer_.times(); }
  std::string about() const { return renderer_.about(); }

 private:
  SceneDrawing drawing_;
  Renderer renderer_;
};

}  // namespace hair
