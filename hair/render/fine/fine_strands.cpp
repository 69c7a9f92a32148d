#include "hair/render/fine/fine_strands.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

// The largest turn of a piece (radians), so that highlights are round, and its largest length in pixels, so
// that shadows along it are visible.
constexpr float kPieceTurn = 0.12F, kPieceLength = 24;

}  // namespace

FineStrands::FineStrands(const StrandsDrawing& drawing, const View& view, int pixels)
    : half_width_(view.length(drawing.width / 2)),
      pixels_(static_cast<float>(pixels) / (2 * view.tangent_y())) {
  first_.reserve(drawing.sizes.size() + 1);
  std::uint32_t next = 0;
  for (const int size : drawing.sizes) {
    first_.push_back(next);
    next += static_cast<std::uint32_t>(size);
  }
  first_.push_back(next);
  at_.reserve(drawing.points.size());
  for (const Vector3d& point : drawing.points) at_.push_back(view.at(point));
}

int FineStrands::pieces(const CurveSegment& segment) const {
  const Eigen::Vector3f begin = segment.slope(0), middle = segment.slope(0.5F), end = segment.slope(1);
  // |a x b| / (a . b) is the tangent of the angle between them; larger angles count as a right angle.
  const auto turn = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    const float sine = a.cross(b).norm(), cosine = a.dot(b);
    return sine < cosine ? sine / cosine : sine > 0 ? 1.6F : 0.0F;
  };
  const float bends = (turn(begin, middle) + turn(middle, end)) / kPieceTurn;
  const float nearest = std::max(-segment.a[2], 0.01F);
  const float length = middle.norm() * pixels_ / nearest / kPieceLength;
  // A bend of less than a pixel needs no pieces.
  const float most = 1 + middle.norm() * pixels_ / nearest;
  return static_cast<int>(
      std::ceil(std::clamp(std::max(std::min(bends, most), length), 1.0F, static_cast<float>(kMostPieces))));
}

int FineStrands::strand_of(std::uint32_t point) const {
  return static_cast<int>(std::upper_bound(first_.begin(), first_.end(), point) - first_.begin()) - 1;
}

}  // namespace hair
