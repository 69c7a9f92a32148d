// Strands of fine hair: their points in the view's axes, and the pieces of the curves through them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hair/render/catmull_rom.h"
#include "hair/render/drawing.h"
#include "hair/render/view.h"

namespace hair {

class FineStrands {
 public:
  // The drawing is one that check_drawing accepts. `pixels`: the height of the picture.
  FineStrands(const StrandsDrawing& drawing, const View& view, int pixels);

  int count() const { return static_cast<int>(first_.size()) - 1; }
  std::span<const Eigen::Vector3f> points() const { return at_; }  // one strand after the other

  int segments(int strand) const { return size(strand) - 1; }
  CurveSegment segment(int strand, int i) const {
    return curve_segment({at_.data() + first_[strand], static_cast<std::size_t>(size(strand))}, i);
  }

  // The number of straight pieces for a segment of a strand, 1 to kMostPieces: enough to make its bends
  // round.
  static constexpr int kMostPieces = 16;
  int pieces(const CurveSegment& segment) const;

  // The place of a point along its strand: 0 at the root, 1 at the tip.
  float along(int strand, int i, float u) const {
    return (static_cast<float>(i) + u) / static_cast<float>(segments(strand));
  }

  // Half the width there, in the view's unit. Over the last part of a strand it falls to 0.
  float half_width(float along) const { return half_width_ * std::min((1 - along) / kTaper, 1.0F); }
  static constexpr float kTaper = 0.2F;

  // The strand of a point, by the point's index among all points.
  int strand_of(std::uint32_t point) const;
  std::uint32_t first(int strand) const { return first_[strand]; }

 private:
  int size(int strand) const { return static_cast<int>(first_[strand + 1] - first_[strand]); }

  std::vector<std::uint32_t> first_;  // each strand's first point, and the number of all points
  std::vector<Eigen::Vector3f> at_;
  float half_width_, pixels_;  // pixels_: at a distance of 1, in the view's unit
};

}  // namespace hair
