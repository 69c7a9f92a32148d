// The key light, far away over the viewer's left shoulder, and its shadow map.
#pragma once

#include <span>
#include <vector>

#include "hair/render/mesh.h"
#include "hair/render/ribbons.h"

namespace hair {

// The direction to the light, in the view's axes.
inline const Eigen::Vector3f kKeyLight = Eigen::Vector3f(-0.5F, 0.75F, 0.6F).normalized();

struct LightMap {
  float radius;        // half a side, in the view's unit; the camera's target is in the middle
  Eigen::Matrix4f to;  // from the view's axes to the map's clip space

  // Half of the map's depth range, in the view's unit.
  static constexpr float kDepth = 4;
};

// The smallest of a few map sizes that contains all nearby shadow casters. The sizes are discrete so that a
// small motion of the hair, or one strand less, changes no other shadow.
// `points`: fine strands, in the view's axes.
LightMap light_map(const std::vector<RibbonVertex>& ribbons, const Mesh& mesh,
                   std::span<const Eigen::Vector3f> points = {});

}  // namespace hair
