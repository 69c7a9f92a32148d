// Everything except hair, as triangles with normals.
#pragma once

#include <cstdint>
#include <vector>

#include "hair/render/drawing.h"
#include "hair/render/view.h"

namespace hair {

struct MeshVertex {
  Eigen::Vector3f at, normal;  // the view's axes
  Colour colour;
  float ground = 0;  // 1 for the ground, so that it fades into the distance
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // three for each triangle; shadow casters first
  std::size_t casting = 0;             // the number of indices of shadow casters
};

// Round shapes get enough corners to keep their outline within a tenth of a sample; the picture's height has
// `samples` samples.
Mesh mesh_of(const Drawing& drawing, const View& view, int samples);

}  // namespace hair
