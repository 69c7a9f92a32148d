#include "hair/render/fine/fine_hair.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

// The part of the light that passes solids, as in the mesh's shader: the mean over the square of two texels
// around a point.
float past_solids(const FineHair::Solids& solids, int size, const Eigen::Vector3f& at) {
  const Eigen::Vector3f clip = solids.light.to.block<3, 3>(0, 0) * at + solids.light.to.block<3, 1>(0, 3);
  const Eigen::Vector3f map = (0.5F + 0.5F * clip.array()).matrix();
  if (!(map[0] >= 0 && map[0] <= 1 && map[1] >= 0 && map[1] <= 1)) return 1;
  const float x = map[0] * static_cast<float>(size), y = map[1] * static_cast<float>(size);
  const float left = std::floor(x), below = std::floor(y), u = x - left, v = y - below;
  const float across[3] = {1 - u, 1, u}, up[3] = {1 - v, 1, v};
  float lit = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const int i = std::clamp(static_cast<int>(left) + column - 1, 0, size - 1),
                j = std::clamp(static_cast<int>(below) + row - 1, 0, size - 1);
      const float depth = solids.light_depths[static_cast<std::size_t>(j) * static_cast<std::size_t>(size) +
                                              static_cast<std::size_t>(i)];
      if (depth > map[2] - solids.bias) lit += across[column] * up[row];
    }
  return lit / 4;
}

}  // namespace

FineHair::FineHair(int threads) : threads_(std::make_unique<StrandThreads>(threads_for(threads))) {}

void FineHair::send(const StrandsDrawing& strands, const View& view, int pixels) {
  opacity_.reset();
  strands_.emplace(strands, view, pixels);
}

HairLayer FineHair::draw(const StrandsDrawing& strands, const View& view, int width, int height,
                         const Solids& solids) {
  HairSurroundings around{.distances = solids.distances, .samples = solids.samples};
  if (opacity_) around.opacity = [this](const Eigen::Vector3f& at) { return opacity_->before(at); };
  const int size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(solids.light_depths.size()))));
  if (size > 0)
    around.lit = [&solids, size](const Eigen::Vector3f& at) { return past_solids(solids, size, at); };
  return draw_hair_layer(strands, *strands_, view, width, height, around, *threads_);
}

}  // namespace hair
