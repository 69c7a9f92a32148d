// STAFF ONLY. The head's surface near some points, by trilinear interpolation of the grid's distances. Points
// are in the grid's own units: cells, from its lowest corner. Single precision is enough for them:
// StepConstants::contact_depth leaves room for its rounding.
#if defined(HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_
#undef HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_
#else
#define HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_
#endif

#include <cstring>

#include "reference/engine/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

using FloatTag = hn::CappedTag<float, 2 * kGroup>;
using Floats = hn::Vec<FloatTag>;
using Floats3 = Three<Floats>;
inline constexpr std::size_t kFloats = hn::MaxLanes(FloatTag());

HWY_INLINE Floats floats(double value) {
  return hn::Set(FloatTag(), static_cast<float>(value));
}

// 1 / |a|, or a large number if a = 0.
HWY_INLINE Floats per_length(const Floats3& a) {
  const Floats squared = hn::Max(floats(1e-30), dot(a, a));
#if HWY_TARGET == HWY_SCALAR
  return floats(1) / hn::Sqrt(squared);
#else
  // 12 bits or more, and Newton's step doubles them.
  const Floats r = hn::ApproximateReciprocalSqrt(squared);
  return hn::MulAdd(floats(0.5) * r, hn::NegMulAdd(squared * r, r, floats(1)), r);
#endif
}

// The cells that points are in. A point beyond the grid gets the nearest cell of the border, and NaN the
// first one. All cells of the border are outside the head.
template <class D>
struct Cells {
  using V = hn::Vec<D>;
  using IntegerTag = hn::Rebind<std::int32_t, D>;
  using Integers = hn::Vec<IntegerTag>;

  HWY_INLINE explicit Cells(const GridView& grid)
      : last{hn::Set(D(), grid.last[0]), hn::Set(D(), grid.last[1]), hn::Set(D(), grid.last[2])},
        count_x(hn::Set(IntegerTag(), grid.count[0])),
        count_y(hn::Set(D(), static_cast<float>(grid.count[1]))) {}

  // The number of a cell's lowest point. `along` becomes the place in the cell, 0 to 1 from there.
  HWY_INLINE Integers index(const Three<V>& point, Three<V>& along) const {
    const auto within = [](V p, V most) { return hn::Min(hn::Max(p, hn::Zero(D())), most); };
    const Three<V> inside{within(point.x, last.x), within(point.y, last.y), within(point.z, last.z)};
    const Three<V> low{hn::Floor(inside.x), hn::Floor(inside.y), hn::Floor(inside.z)};
    along = inside - low;
    // Single precision holds the number of a row, which is less than 2^24.
    return hn::ConvertTo(IntegerTag(), hn::MulAdd(low.z, count_y, low.y)) * count_x +
           hn::ConvertTo(IntegerTag(), low.x);
  }

  Three<V> last;
  Integers count_x;
  V count_y;
};

// The distances at the corners of some points' cells: four gathers, each of two neighbours along x.
class CellCorners {
 public:
  HWY_INLINE CellCorners(const GridView& grid, const Cells<FloatTag>& cells, const Floats3& point) {
    const Integers index = cells.index(point, along_);
    for (int dk = 0; dk < 2; ++dk)
      for (int dj = 0; dj < 2; ++dj) pairs_[2 * dk + dj] = pair(grid, index, dj, dk);
  }

  // The first of two neighbours' distances, and the second's difference from it.
  struct Edge {
    Floats low, slope;
  };
  // The edge at these steps in y and z.
  HWY_INLINE Edge edge(int dj, int dk) const {
    const Integers both = pairs_[2 * dk + dj];
    const Floats low = hn::ConvertTo(FloatTag(), hn::ShiftRight<16>(hn::ShiftLeft<16>(both)));
    return {low, hn::ConvertTo(FloatTag(), hn::ShiftRight<16>(both)) - low};
  }
  // The place in the cell, 0 to 1 from its lowest corner.
  HWY_INLINE const Floats3& along() const { return along_; }

 private:
  using Integers = hn::Vec<hn::Rebind<std::int32_t, FloatTag>>;

  static HWY_INLINE Integers pair(const GridView& grid, Integers index, int dj, int dk) {
    const std::int16_t* const from = grid.distance + (dk * grid.count[1] + dj) * grid.count[0];
#if HWY_TARGET == HWY_SCALAR
    Integers both;
    std::memcpy(&both.raw, from + index.raw, sizeof(both.raw));
    return both;
#else
    const hn::Rebind<std::int32_t, FloatTag> integers;
    return hn::GatherOffset(integers, reinterpret_cast<const std::int32_t*>(from), hn::ShiftLeft<1>(index));
#endif
  }

  Floats3 along_;
  Integers pairs_[4];
};

struct HeadSurface {
  Floats depth;    // in cells, > 0 inside; else 0
  Floats3 normal;  // has length 1 where depth > 0

  HWY_INLINE HeadSurface(Floats most_per_slope, const CellCorners& corners) {
    const Floats3& t = corners.along();
    const auto mix = [](Floats a, Floats slope, Floats s) { return hn::MulAdd(s, slope, a); };
    const CellCorners::Edge e00 = corners.edge(0, 0), e10 = corners.edge(1, 0), e01 = corners.edge(0, 1),
                            e11 = corners.edge(1, 1);
    const Floats c00 = mix(e00.low, e00.slope, t.x), c01 = mix(e01.low, e01.slope, t.x);
    const Floats y0 = mix(e10.low, e10.slope, t.x) - c00, y1 = mix(e11.low, e11.slope, t.x) - c01;
    const Floats x0 = mix(e00.slope, e10.slope - e00.slope, t.y),
                 x1 = mix(e01.slope, e11.slope - e01.slope, t.y);
    const Floats c0 = mix(c00, y0, t.y), z = mix(c01, y1, t.y) - c0;
    const Floats3 gradient{mix(x0, x1 - x0, t.z), mix(y0, y1 - y0, t.z), z};
    const Floats per_slope = per_length(gradient);
    // The gradient is in differences between the grid's points.
    depth = hn::Max(hn::Zero(FloatTag()) - mix(c0, z, t.z), hn::Zero(FloatTag())) *
            hn::Min(per_slope, most_per_slope);
    normal = per_slope * gradient;
  }
};

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
