// All that is not hair, as triangles with normals.
#pragma once

#include <cstdint>
#include <vector>

#include "hair/render/drawing.h"
#include "hair/render/view.h"

namespace hair {

struct MeshVertex {
  Eigen::Vector3f at, normal;  // the view's axes
  Colour colour;
  float ground = 0;  // of ground: 1, so that it fades into the distance
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // three for each triangle; of what casts shadows first
  std::size_t casting = 0;             // indices
};

// Round things get as many corners as keep their outline within a tenth of a sample, `samples` of which are
// in the picture's height.
Mesh mesh_of(const Drawing& drawing, const View& view, int samples);

}  // namespace hair
