// STAFF ONLY. The head's surface near some points: distances between a grid's points by trilinear interpolation. Points are in
// the grid's own units: cells, from its lowest corner. Single precision does for them: StepConstants::contact_depth leaves
// room for its rounding.
#if defined(HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_
#undef HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_
#else
#define HAIR_REFERENCE_ENGINE_HEAD_SURFACE_H_
#endif

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

// 1 / |a|; where a = 0 a large number.
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

// The cells that points are in. A point beyond the grid, or without numbers, gets the cell of the border that is next to it (or
// the first one): all of those are outside the head.
template <class D>
struct Cells {
  using V = hn::Vec<D>;
  using Integers = hn::Vec<hn::Rebind<std::int32_t, D>>;

  HWY_INLINE Cells(const GridView& grid, const Three<V>& point) {
    const D tag;
    const hn::Rebind<std::int32_t, D> integers;
    const auto within = [&](V p, int axis) {
      return hn::Min(hn::Max(p, hn::Zero(tag)), hn::Set(tag, grid.last[axis]));
    };
    const Three<V> inside{within(point.x, 0), within(point.y, 1), within(point.z, 2)};
    const Three<V> low{hn::Floor(inside.x), hn::Floor(inside.y), hn::Floor(inside.z)};
    const auto count = [&](int axis) { return hn::Set(integers, grid.count[axis]); };
    index = (hn::ConvertTo(integers, low.z) * count(1) + hn::ConvertTo(integers, low.y)) * count(0) +
            hn::ConvertTo(integers, low.x);
    along = inside - low;
  }

  Integers index;  // of a cell's lowest point
  Three<V> along;  // 0 to 1, from there
};

struct HeadSurface {
  Floats depth;    // in cells, > 0 inside; else 0
  Floats3 normal;  // of length 1 where depth > 0

  HWY_INLINE HeadSurface(const GridView& grid, const Floats3& point) {
    const Cells<FloatTag> cells(grid, point);
    const Floats3& t = cells.along;
    const auto corner = [&](int di, int dj, int dk) {
      const float* const from = grid.distance + (dk * grid.count[1] + dj) * grid.count[0] + di;
      return hn::GatherIndex(FloatTag(), from, cells.index);
    };
    const auto mix = [](Floats a, Floats slope, Floats s) { return hn::MulAdd(s, slope, a); };
    const Floats c000 = corner(0, 0, 0), c010 = corner(0, 1, 0), c001 = corner(0, 0, 1),
                 c011 = corner(0, 1, 1);
    const Floats s00 = corner(1, 0, 0) - c000, s10 = corner(1, 1, 0) - c010, s01 = corner(1, 0, 1) - c001,
                 s11 = corner(1, 1, 1) - c011;
    const Floats c00 = mix(c000, s00, t.x), c01 = mix(c001, s01, t.x);
    const Floats y0 = mix(c010, s10, t.x) - c00, y1 = mix(c011, s11, t.x) - c01;
    const Floats x0 = mix(s00, s10 - s00, t.y), x1 = mix(s01, s11 - s01, t.y);
    const Floats c0 = mix(c00, y0, t.y), z = mix(c01, y1, t.y) - c0;
    const Floats3 gradient{mix(x0, x1 - x0, t.z), mix(y0, y1 - y0, t.z), z};
    const Floats per_slope = per_length(gradient);
    // The gradient is one of differences between the grid's points, which are metres.
    depth = hn::Max(hn::Zero(FloatTag()) - mix(c0, z, t.z), hn::Zero(FloatTag())) *
            hn::Min(per_slope, floats(grid.per_cell / kLeastSlope));
    normal = per_slope * gradient;
  }
};

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
