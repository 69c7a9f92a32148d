#include "hair/render/fine/opacity_map.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>

namespace hair {
namespace {

constexpr float kUnit = 16384;  // a texel that is covered once
constexpr int kStrandsOfATask = 256;

// The four texels around a place, with weights.
struct Footprint {
  int x, y;
  std::array<float, 4> weights;  // for (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)
};

Footprint footprint(float x, float y) {
  const float left = std::floor(x - 0.5F), below = std::floor(y - 0.5F);
  const float u = x - 0.5F - left, v = y - 0.5F - below;
  return {
      static_cast<int>(left), static_cast<int>(below), {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

// Calls visit(texel, depth, share) for each texel of a piece of hair, with the area of its shadow there.
template <class Visit>
void splat(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float width, int size,
           const Visit& visit) {
  const Eigen::Vector3f way = to - from;
  const float length = way.head<2>().norm();
  const float samples = std::clamp(std::ceil(length), 1.0F, 4.0F * static_cast<float>(size));
  const float area = length / samples * std::min(width, 1.0F);
  const auto side = static_cast<float>(size);
  for (float k = 0.5F; k < samples; ++k) {
    const Eigen::Vector3f at = from + k / samples * way;
    if (!(at[0] >= 0 && at[0] < side && at[1] >= 0 && at[1] < side && at[2] >= 0 && at[2] <= 1)) continue;
    const Footprint near = footprint(at[0], at[1]);
    for (int corner = 0; corner < 4; ++corner) {
      const int x = near.x + (corner & 1), y = near.y + (corner >> 1);
      if (x >= 0 && x < size && y >= 0 && y < size && near.weights[corner] > 0)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x),
              at[2], area * near.weights[corner]);
    }
  }
}

// The bits of positive floats have the same order as their values.
void lower(std::atomic<std::uint32_t>& place, float depth) {
  const auto bits = std::bit_cast<std::uint32_t>(depth);
  std::uint32_t now = place.load(std::memory_order_relaxed);
  while (bits < now && !place.compare_exchange_weak(now, bits, std::memory_order_relaxed)) {
  }
}

}  // namespace

Eigen::Vector4f OpacityMap::ends(const LightMap& light) {
  return Eigen::Vector4f(0.015F, 0.05F, 0.15F, 0.5F) * light.radius / LightMap::kDepth;
}

Eigen::Vector3f OpacityMap::to_map(const Eigen::Vector3f& at) const {
  const Eigen::Vector3f clip = light_.to.block<3, 3>(0, 0) * at + light_.to.block<3, 1>(0, 3);
  const auto size = static_cast<float>(size_);
  return {(0.5F + 0.5F * clip[0]) * size, (0.5F + 0.5F * clip[1]) * size, 0.5F + 0.5F * clip[2]};
}

OpacityMap::OpacityMap(const LightMap& light, int size, const FineStrands& strands, StrandThreads& threads)
    : light_(light), size_(size), ends_(ends(light)) {
  const float texel = 2 * light.radius / static_cast<float>(size);
  skip_ = std::max(texel, strands.half_width(0)) / LightMap::kDepth;
  const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<std::atomic<std::uint32_t>> first(texels), areas(kLayers * texels);
  for (std::atomic<std::uint32_t>& depth : first)
    depth.store(std::bit_cast<std::uint32_t>(1.0F), std::memory_order_relaxed);

  const auto for_each_texel = [&](const auto& visit) {
    const StrandThreads::Task task = [&](int, int batch) {
      const int end = std::min(strands.count(), (batch + 1) * kStrandsOfATask);
      for (int strand = batch * kStrandsOfATask; strand < end; ++strand)
        for (int i = 0; i < strands.segments(strand); ++i) {
          const CurveSegment segment = strands.segment(strand, i);
          const int pieces = strands.pieces(segment);
          Eigen::Vector3f from = to_map(segment.a);
          for (int k = 1; k <= pieces; ++k) {
            const float u = static_cast<float>(k) / static_cast<float>(pieces);
            const Eigen::Vector3f to = to_map(segment.at(u));
            const float along = strands.along(strand, i, u - 0.5F / static_cast<float>(pieces));
            splat(from, to, 2 * strands.half_width(along) / texel, size, visit);
            from = to;
          }
        }
    };
    threads.run((strands.count() + kStrandsOfATask - 1) / kStrandsOfATask, task);
  };
  for_each_texel([&](std::size_t at, float depth, float) { lower(first[at], depth); });
  for_each_texel([&](std::size_t at, float depth, float area) {
    const float behind = depth - std::bit_cast<float>(first[at].load(std::memory_order_relaxed));
    const int layer = behind <= ends_[0] ? 0 : behind <= ends_[1] ? 1 : behind <= ends_[2] ? 2 : 3;
    areas[kLayers * at + static_cast<std::size_t>(layer)].fetch_add(
        static_cast<std::uint32_t>(std::lrint(area * kUnit)), std::memory_order_relaxed);
  });

  first_.resize(texels);
  opacity_.resize(kLayers * texels);
  for (std::size_t at = 0; at < texels; ++at) {
    first_[at] = std::bit_cast<float>(first[at].load());
    float sum = 0;
    for (std::size_t layer = kLayers * at; layer < kLayers * (at + 1); ++layer)
      opacity_[layer] = sum += static_cast<float>(areas[layer].load()) / kUnit;
  }
}

float OpacityMap::texel_opacity(int x, int y, float depth) const {
  x = std::clamp(x, 0, size_ - 1);
  y = std::clamp(y, 0, size_ - 1);
  const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(x);
  const float behind = depth - skip_ - first_[at];
  if (behind <= 0) return 0;
  float sum = 0, begin = 0, before = 0;
  for (int layer = 0; layer < kLayers; ++layer) {
    const float with = opacity_[kLayers * at + static_cast<std::size_t>(layer)];
    sum += (with - before) * std::clamp((behind - begin) / (ends_[layer] - begin), 0.0F, 1.0F);
    before = with;
    begin = ends_[layer];
  }
  return sum;
}

float OpacityMap::before(const Eigen::Vector3f& at) const {
  const Eigen::Vector3f place = to_map(at);
  const auto size = static_cast<float>(size_);
  if (!(place[0] >= 0 && place[0] <= size && place[1] >= 0 && place[1] <= size)) return 0;
  const Footprint near = footprint(place[0], place[1]);
  float sum = 0;
  for (int corner = 0; corner < 4; ++corner)
    sum += near.weights[corner] * texel_opacity(near.x + (corner & 1), near.y + (corner >> 1), place[2]);
  return sum;
}

}  // namespace hair
