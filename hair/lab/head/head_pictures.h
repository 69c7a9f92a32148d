// Pictures of a head in the middle of its motion. The camera is the same for hair made of few guides, of
// many, and simulated strand by strand.
#pragma once

#include <memory>
#include <span>

#include "hair/lab/head/head_study.h"
#include "hair/render/opengl/renderer.h"

namespace hair::head_study {

class HeadPictures {
 public:
  // Throws NoOpenGl.
  explicit HeadPictures(const Bust& bust);

  // Forgets the camera: the next hair belongs to another head.
  void begin() { camera_.reset(); }

  // Draws the moment kPictured. points: 3 numbers each, strand after strand. The first call after begin()
  // chooses the camera.
  Image draw(std::span<const double> points, int points_of_strand);

 private:
  Renderer renderer_;
  std::shared_ptr<const SurfaceMesh> mesh_;
  std::optional<Camera> camera_;
};

// The numbers of guides in pictures, out of those studied: 100 or the fewest, 1,000 or the most.
struct PicturedGuides {
  int few, many;
};
PicturedGuides pictured_guides(const std::vector<int>& guides);

}  // namespace hair::head_study
