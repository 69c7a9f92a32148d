// The shadows of hair: a deep opacity map. C. Yuksel and J. Keyser, "Deep Opacity Maps", Computer Graphics
// Forum 27(2), 2008. A texel of the light's view stores the depth where the light first meets hair, and the
// amount of hair in layers behind that. So layers follow the hair's shape, and few of them are enough.
//
// Opacity is an optical depth: the part exp(-opacity) of the light passes. Strands whose shadows cover the
// part c of a texel, counting all overlaps, add c. They are far thinner than texels, so the map's opacity is
// exact on average. Its sums are of whole numbers, the same in any order.
#pragma once

#include <cstdint>
#include <vector>

#include "hair/render/fine/fine_strands.h"
#include "hair/render/light.h"
#include "hair/simulation/strand_threads.h"

namespace hair {

class OpacityMap {
 public:
  static constexpr int kLayers = 4;

  // size x size texels. All strands count, also those that no camera sees.
  OpacityMap(const LightMap& light, int size, const FineStrands& strands, StrandThreads& threads);

  // The opacity between the light and a point in the view's axes, interpolated between texels and within
  // layers. It is 0 outside of the map. A point within a texel's width of the first hair is in full light.
  float before(const Eigen::Vector3f& at) const;

  // For OpenGL's textures: row after row, the lowest first. The first depth is 0 to 1 (1: no hair); the
  // opacity of a layer includes all layers before it.
  const std::vector<float>& first() const { return first_; }
  const std::vector<float>& opacity() const { return opacity_; }

  // The ends of the layers, and the depth that is in full light, as parts of the map's depth.
  static Eigen::Vector4f ends(const LightMap& light);
  float skip() const { return skip_; }

 private:
  Eigen::Vector3f to_map(const Eigen::Vector3f& at) const;  // texels, texels, depth
  float texel_opacity(int x, int y, float depth) const;

  LightMap light_;
  int size_;
  Eigen::Vector4f ends_;
  float skip_;
  std::vector<float> first_, opacity_;
};

}  // namespace hair
