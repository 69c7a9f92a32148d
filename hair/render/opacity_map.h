// The shadows that hair throws: a deep opacity map. C. Yuksel and J. Keyser, "Deep Opacity Maps", Computer
// Graphics Forum 27(2), 2008. A texel of the light's view knows where the light first meets hair, and how
// much hair is in layers behind that. So layers follow the hair's shape, and few of them are enough.
//
// Opacity is an optical depth: the part exp(-opacity) of the light comes through. Strands whose shadows cover
// the part c of a texel, all overlaps counted, add c. They are far thinner than texels; so the map's opacity
// is exact on average, and sums are of whole numbers, the same in any order.
#pragma once

#include <cstdint>
#include <vector>

#include "hair/render/fine_strands.h"
#include "hair/render/light.h"
#include "hair/simulation/strand_threads.h"

namespace hair {

class OpacityMap {
 public:
  static constexpr int kLayers = 4;

  // size x size texels. All strands count, also those that no camera sees.
  OpacityMap(const LightMap& light, int size, const FineStrands& strands, StrandThreads& threads);

  // The opacity between the light and a point in the view's axes, interpolated between texels and within
  // layers. 0 outside of the map. What is nearer to the first hair than a texel is wide is in full light.
  float before(const Eigen::Vector3f& at) const;

  // As OpenGL's textures have them: row after row from the bottom up. The first depth, 0 to 1 (1: no hair),
  // and the opacity of each layer together with those before it.
  const std::vector<float>& first() const { return first_; }
  const std::vector<float>& opacity() const { return opacity_; }

  // Where the layers end, and the depth that is in full light, as parts of the map's depth.
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
