// Fine hair in a picture, step by step: the strands, then their shadows, then the visible layer. The
// processor draws it with all of its threads; OpenGL draws the rest.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hair/render/fine/hair_layer.h"
#include "hair/render/fine/opacity_map.h"

namespace hair {

class FineHair {
 public:
  // threads: 0: as many as the machine has. Any number gives the same picture.
  explicit FineHair(int threads = 0);

  // Forgets the opacity of earlier strands.
  void send(const StrandsDrawing& strands, const View& view, int pixels);

  bool empty() const { return !strands_ || strands_->points().empty(); }
  std::span<const Eigen::Vector3f> points() const { return strands_->points(); }

  // Without this call hair has no shadows of its own.
  void make_opacity(const LightMap& light, int size) { opacity_.emplace(light, size, *strands_, *threads_); }
  const OpacityMap& opacity() const { return *opacity_; }

  // The results of OpenGL.
  struct Solids {
    std::vector<float> distances = {};  // see HairSurroundings; empty: there are no solids
    int samples = 1;
    std::vector<float> light_depths = {};  // the light's map of solids, a square; empty: no shadows
    LightMap light = {};
    float bias = 0;  // a point is lit if its depth is behind a solid by less
  };
  HairLayer draw(const StrandsDrawing& strands, const View& view, int width, int height,
                 const Solids& solids);

 private:
  std::unique_ptr<StrandThreads> threads_;
  std::optional<FineStrands> strands_;
  std::optional<OpacityMap> opacity_;
};

}  // namespace hair
