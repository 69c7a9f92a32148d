// Fine hair in a picture, step by step: strands, then how they throw shadows, then the layer that is seen.
// The processor draws it, in all of its threads; OpenGL draws the rest.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hair/render/hair_layer.h"
#include "hair/render/opacity_map.h"

namespace hair {

class FineHair {
 public:
  // threads: 0: as many as the machine has. The picture is the same with any number.
  explicit FineHair(int threads = 0);

  // Forgets the opacity of the strands before.
  void send(const StrandsDrawing& strands, const View& view, int pixels);

  bool empty() const { return !strands_ || strands_->points().empty(); }
  std::span<const Eigen::Vector3f> points() const { return strands_->points(); }

  // Without it hair is drawn without its own shadows.
  void make_opacity(const LightMap& light, int size) { opacity_.emplace(light, size, *strands_, *threads_); }
  const OpacityMap& opacity() const { return *opacity_; }

  // What OpenGL has drawn.
  struct Solids {
    std::vector<float> distances = {};  // as HairSurroundings has them; empty: there are none
    int samples = 1;
    std::vector<float> light_depths = {};  // the light's map of them, a square; empty: they throw no shadows
    LightMap light = {};
    float bias = 0;  // what is behind a solid by less, in depth, is lit
  };
  HairLayer draw(const StrandsDrawing& strands, const View& view, int width, int height,
                 const Solids& solids);

 private:
  std::unique_ptr<StrandThreads> threads_;
  std::optional<FineStrands> strands_;
  std::optional<OpacityMap> opacity_;
};

}  // namespace hair
