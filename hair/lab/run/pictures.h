// Draws pictures of a scene while it plays. The constructor loads the OpenGL libraries, so runs without
// pictures don't.
#pragma once

#include "hair/render/renderer.h"
#include "hair/render/scene_drawing.h"
#include "hair/scene/playback.h"
#include "hair/scene/scene.h"

namespace hair {

class Pictures {
 public:
  // strands, cache: as SceneDrawing has them. The scene must have a look and outlive this object. Throws NoOpenGl.
  Pictures(const Scene& scene, const std::vector<int>& strands,
           const std::optional<std::filesystem::path>& cache);

  // As SceneDrawing::at.
  Image draw(const particles::State& state, const std::vector<Obstacle>& obstacles, double time,
             const MeshRecord* mesh);

  const SceneDrawing& drawing() const { return drawing_; }
  const SynthesisCounts& synthesised() const { return drawing_.synthesised(); }  // in the last picture
  long moved_out() const { return drawing_.moved_out(); }
  const RenderTimes& times() const { return renderer_.times(); }
  std::string about() const { return renderer_.about(); }

 private:
  SceneDrawing drawing_;
  Renderer renderer_;
};

}  // namespace hair
