// Strands as ribbons that face the eye: each point becomes two vertices, which the vertex shader moves apart.
// If a strand has few points, a curve goes through them (catmull_rom.h).
#pragma once

#include <cstdint>
#include <vector>

#include "hair/render/drawing.h"
#include "hair/render/view.h"

namespace hair {

struct RibbonVertex {
  Eigen::Vector3f at, tangent;  // the view's axes
  float along;                  // 0 at the root, 1 at the tip
  float tone;                   // a number from -1 to 1 for each strand
};

// Vertices 2i and 2i + 1 are the two sides of point i.
std::vector<RibbonVertex> ribbon_vertices(const StrandsDrawing& strands, const View& view);

// Triangle strips, one a strand, with a restart between them.
inline constexpr std::uint32_t kRestart = 0xffffffffU;
std::vector<std::uint32_t> ribbon_indices(const std::vector<int>& sizes);

}  // namespace hair
