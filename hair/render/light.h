// The key light, which comes from far away, over the viewer's left shoulder, and the map of what it meets.
#pragma once

#include <vector>

#include "hair/render/mesh.h"
#include "hair/render/ribbons.h"

namespace hair {

// To the light, in the view's axes.
inline const Eigen::Vector3f kKeyLight = Eigen::Vector3f(-0.5F, 0.75F, 0.6F).normalized();

struct LightMap {
  float radius;        // half a side, in the view's unit; the camera's target is in the middle
  Eigen::Matrix4f to;  // from the view's axes to the map's clip space

  // Half of the depth that the map has, in the view's unit.
  static constexpr float kDepth = 4;
};

// The smallest map of a few sizes that has in it all that casts shadows, as far as it is near: hair that
// moves a little, or one strand less, changes no other shadow.
LightMap light_map(const std::vector<RibbonVertex>& ribbons, const Mesh& mesh);

}  // namespace hair
