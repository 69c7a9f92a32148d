#include "hair/render/ribbons.h"

#include <algorithm>

#include "hair/render/catmull_rom.h"

namespace hair {
namespace {

// A strand has at least this many pieces, so that its bends are round.
constexpr int kPieces = 60;

// The number of pieces of a segment. Two points are a straight line, whose last fifth tapers.
int pieces_of(int points) {
  return points <= 2 ? 5 : std::clamp((kPieces + points - 2) / (points - 1), 1, 12);
}

// A number from -1 to 1 for each strand, without a pattern. The steps are those of the finaliser of
// MurmurHash3 (A. Appleby, public domain).
float tone_of(std::uint32_t strand) {
  std::uint32_t h = strand + 0x9e3779b9U;
  h = (h ^ h >> 16) * 0x85ebca6bU;
  h = (h ^ h >> 13) * 0xc2b2ae35U;
  h ^= h >> 16;
  return static_cast<float>(h >> 8) / 8388608.0F - 1.0F;
}

}  // namespace

std::vector<RibbonVertex> ribbon_vertices(const StrandsDrawing& strands, const View& view) {
  std::size_t total = 0;
  for (const int size : strands.sizes) {
    total += 2 * static_cast<std::size_t>(pieces_of(size) * (size - 1) + 1);
  }
  std::vector<RibbonVertex> vertices;
  vertices.reserve(total);

  std::vector<Eigen::Vector3f> at;
  std::size_t first = 0;
  for (std::size_t strand = 0; strand < strands.sizes.size(); ++strand) {
    const int size = strands.sizes[strand], pieces = pieces_of(size), end = pieces * (size - 1);
    at.clear();
    for (int i = 0; i < size; ++i) at.push_back(view.at(strands.points[first + static_cast<std::size_t>(i)]));
    first += static_cast<std::size_t>(size);
    const float tone = tone_of(static_cast<std::uint32_t>(strand));

    Eigen::Vector3f last(0, 1, 0);
    for (int k = 0; k <= end; ++k) {
      const int i = std::min(k / pieces, std::max(size - 2, 0));
      const float u = static_cast<float>(k - i * pieces) / static_cast<float>(pieces);
      const CurveSegment segment = curve_segment(at, i);
      const Eigen::Vector3f slope = segment.slope(u);
      const float steepness = slope.norm();
      if (steepness > 1e-12F) last = slope / steepness;
      const RibbonVertex vertex{segment.at(u), last,
                                static_cast<float>(k) / static_cast<float>(std::max(end, 1)), tone};
      vertices.push_back(vertex);
      vertices.push_back(vertex);
    }
  }
  return vertices;
}

std::vector<std::uint32_t> ribbon_indices(const std::vector<int>& sizes) {
  std::vector<std::uint32_t> indices;
  std::uint32_t next = 0;
  for (const int size : sizes) {
    const int points = pieces_of(size) * (size - 1) + 1;
    for (int i = 0; i < 2 * points; ++i) indices.push_back(next++);
    indices.push_back(kRestart);
  }
  return indices;
}

}  // namespace hair
