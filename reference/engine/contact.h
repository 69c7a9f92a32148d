// STAFF ONLY. Steps 5 and 6 of hair/dense/full_head.h: velocities, the way back to memory, and the head. It
// first lists a group's points that are near the head, of all strands together, and then pushes them out, as
// many at a time as a vector of single precision has lanes.
#if defined(HAIR_REFERENCE_ENGINE_CONTACT_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_CONTACT_H_
#undef HAIR_REFERENCE_ENGINE_CONTACT_H_
#else
#define HAIR_REFERENCE_ENGINE_CONTACT_H_
#endif

#include <array>
#include <bit>

#include "reference/engine/head_surface.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

inline constexpr int kMostPushes = 20;

// The part of a vector that friction takes away: that across n, at most `limit` long.
HWY_INLINE Floats3 friction(const Floats3& vector, const Floats3& n, Floats limit) {
  const Floats3 across = minus(vector, dot(n, vector), n);
  return hn::Min(floats(1), limit * per_length(across)) * across;
}

// The lanes of `which` move to the front. For eight lanes and AVX2, Highway's Compress copies its table, a
// kilobyte, to the stack at each call (g++ 12).
template <class D, class V, class M>
HWY_INLINE V to_front([[maybe_unused]] D tag, V a, M which) {
#if HWY_TARGET == HWY_AVX2
  if constexpr (hn::MaxLanes(tag) == 8) {
    static constexpr auto kTable = [] {
      std::array<std::array<std::uint8_t, 8>, 256> lanes{};
      for (unsigned bits = 0; bits < 256; ++bits)
        for (unsigned lane = 0, next = 0; lane < 8; ++lane)
          if (bits >> lane & 1) lanes[bits][next++] = static_cast<std::uint8_t>(lane);
      return lanes;
    }();
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, which, bits);
    const auto lanes = hn::PromoteTo(hn::Rebind<std::int32_t, D>(),
                                     hn::LoadU(hn::Rebind<std::uint8_t, D>(), kTable[*bits].data()));
    return hn::TableLookupLanes(a, hn::IndicesFromVec(tag, lanes));
  }
#endif
  return hn::Compress(a, which);
}

// The points of a group that are near the head, in the grid's units and the head's axes.
class NearHead {
 public:
  HWY_INLINE NearHead(const StepConstants& step, const Scratch& scratch)
      : step_(step),
        to_cells_(step.cells_after),
        before_to_cells_(step.cells_before),
        cells_(step.grid),
        rows_(scratch.near),
        index_in_group_(scratch.near_index),
        row_(scratch.near_row) {}

  // Adds points that moved from `old` to `now`. `at` is the index of the first lane's x in the group.
  HWY_INLINE void add(const Vec3& old, const Vec3& now, std::int32_t at) {
    const HalfTag tag;
    const hn::Rebind<std::int32_t, Tag> integers;
    const Vec3 p = to_cells_(now);
    const Three<Half> place = half(p);
    Three<Half> along;
    const auto index = cells_.index(place, along);
    const auto word = hn::GatherIndex(integers, step_.grid.reaches_inside, hn::ShiftRight<5>(index));
    const auto bit = hn::And(word >> hn::And(index, hn::Set(integers, 31)), hn::Set(integers, 1));
    const auto near = bit != hn::Zero(integers);
    if (hn::AllFalse(integers, near)) return;
    const Three<Half> way = half(p - before_to_cells_(old));
    const auto which = hn::RebindMask(tag, near);
    keep(tag, which, place, kPlace, count_);
    keep(tag, which, way, kWay, count_);
    hn::StoreU(hn::Compress(hn::Iota(integers, at), near), integers, index_in_group_ + count_);
    count_ += hn::CountTrue(integers, near);
  }

  // Changes x and v. Points that need another push move up, so that vectors stay full.
  HWY_INLINE void push_out(const Group& group) {
    const FloatTag tag;
    const Floats zero = hn::Zero(tag), mu = floats(step_.friction), per_h = floats(step_.per_h);
    const Floats rest = floats(step_.contact_depth * step_.grid.per_cell);
    const Floats most_per_slope = floats(step_.grid.per_cell * step_.grid.unit / kLeastSlope);
    const Cells<FloatTag> cells(step_.grid);
    Floats3 turn[3];
    for (int row = 0; row < 3; ++row) {
      const auto part = [&](int column) {
        return floats(step_.after.turn[row][column] / step_.grid.per_cell);
      };
      turn[row] = {part(0), part(1), part(2)};
    }
    for (int push = 0; push < kMostPushes && count_ > 0; ++push) {
      std::size_t left = 0;
      Floats3 next_place = read(kPlace, 0);
      CellCorners next_corners(step_.grid, cells, next_place);
      for (std::size_t k = 0; k < count_; k += kFloats) {
        const Floats3 place = next_place;
        const CellCorners corners = next_corners;
        // The nearest cache does not hold the next points' distances: they are fetched while these points are
        // pushed.
        if (k + kFloats < count_) {
          next_place = read(kPlace, k + kFloats);
          next_corners = CellCorners(step_.grid, cells, next_place);
        }
        const HeadSurface surface(most_per_slope, corners);
        const auto inside = hn::And(surface.depth > (push == 0 ? zero : rest), hn::FirstN(tag, count_ - k));
        if (hn::AllFalse(tag, inside)) continue;
        const Floats3 &n = surface.normal, way = read(kWay, k);
        const Floats3 u = push == 0 ? per_h * way : read(kSpeed, k);
        const Floats3 shift = surface.depth * n - friction(way, n, mu * surface.depth);
        const Floats speed = hn::Max(zero - dot(n, u), zero);
        const Floats3 change = speed * n - friction(u, n, mu * speed);
        add_to(group, k, inside, turn, shift, change);
        // After a short push, Newton's next error is less than the depth asked for: a grid's cells differ in
        // slope by less than a tenth. Each point ends by itself.
        const auto again = hn::And(inside, surface.depth > floats(10) * rest);
        keep(tag, again, place + shift, kPlace, left);
        keep(tag, again, way + shift, kWay, left);
        keep(tag, again, u + change, kSpeed, left);
        const hn::Rebind<std::int32_t, FloatTag> integers;
        const auto indices = hn::LoadU(integers, index_in_group_ + k);
        hn::StoreU(to_front(integers, indices, hn::RebindMask(integers, again)), integers,
                   index_in_group_ + left);
        left += hn::CountTrue(tag, again);
      }
      count_ = left;
    }
  }

 private:
  using HalfTag = hn::Rebind<float, Tag>;
  using Half = hn::Vec<HalfTag>;
  // The first rows of places, ways and velocities near the head.
  enum Row : std::size_t { kPlace = 0, kWay = 3, kSpeed = 6 };

  HWY_INLINE float* number(std::size_t row, std::size_t k) { return rows_ + row * row_ + k; }
  HWY_INLINE Floats3 read(Row first, std::size_t k) {
    const FloatTag tag;
    return {hn::LoadU(tag, number(first, k)), hn::LoadU(tag, number(first + 1, k)),
            hn::LoadU(tag, number(first + 2, k))};
  }
  // Stores whole vectors; the next ones overwrite the lanes that are too many. Some processors take
  // hundreds of cycles to store the lanes that a mask picks.
  template <class D, class M>
  HWY_INLINE void keep(D tag, M which, const Three<hn::Vec<D>>& a, Row first, std::size_t k) {
    hn::StoreU(to_front(tag, a.x, which), tag, number(first, k));
    hn::StoreU(to_front(tag, a.y, which), tag, number(first + 1, k));
    hn::StoreU(to_front(tag, a.z, which), tag, number(first + 2, k));
  }
  static HWY_INLINE Three<Half> half(const Vec3& a) {
    const HalfTag tag;
    return {hn::DemoteTo(tag, a.x), hn::DemoteTo(tag, a.y), hn::DemoteTo(tag, a.z)};
  }

  // Stores all lanes at once. One by one each number would wait for its own change of precision.
  static HWY_INLINE void store_doubles(Floats a, double* to) {
#if HWY_TARGET == HWY_SCALAR
    *to = a.raw;
#else
    const hn::CappedTag<double, kFloats / 2> tag;
    hn::Store(hn::PromoteTo(tag, hn::LowerHalf(a)), tag, to);
    hn::Store(hn::PromoteTo(tag, hn::UpperHalf(hn::Half<FloatTag>(), a)), tag, to + kFloats / 2);
#endif
  }

  // Adds to x and v of the points from k on, in the lanes `which`.
  template <class M>
  HWY_INLINE void add_to(const Group& group, std::size_t k, M which, const Floats3 (&turn)[3],
                         const Floats3& shift, const Floats3& change) {
    const FloatTag tag;
    HWY_ALIGN double numbers[6][kFloats];
    const auto turned = [&](const Floats3& a, double(*to)[kFloats]) {
      for (int row = 0; row < 3; ++row) store_doubles(dot(turn[row], a), to[row]);
    };
    turned(shift, numbers);
    turned(change, numbers + 3);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(tag, which, bytes);
    for (unsigned bits = bytes[0] | bytes[1] << 8; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      double* const x = group.x + index_in_group_[k + lane];
      double* const v = group.v + index_in_group_[k + lane];
      for (int axis = 0; axis < 3; ++axis) {
        x[axis * kGroup] += numbers[axis][lane];
        v[axis * kGroup] += numbers[3 + axis][lane];
      }
    }
  }

  const StepConstants& step_;
  const Axes to_cells_, before_to_cells_;
  const Cells<HalfTag> cells_;
  float* rows_;
  std::int32_t* index_in_group_;
  std::size_t row_, count_ = 0;
};

template <bool kContact>
HWY_NOINLINE void finish(const StepConstants& step, const Group& group, std::size_t lane, const double* moved,
                         const Scratch& scratch) {
  Which finite = all(0) == all(0);
  const Lanes infinite = hn::Inf(Tag());
  NearHead near(step, scratch);
  for (int i = 0; i < group.points; ++i) {
    const std::size_t at = 3 * i * kGroup + lane;
    const Vec3 old = load3<kGroup>(group.x + at), now = load3<kWidth>(moved + 3 * i * kWidth);
    const Vec3 v = all(step.per_h) * (now - old);
    store3<kGroup>(now, group.x + at);
    store3<kGroup>(v, group.v + at);
    if constexpr (kContact)
      if (i > 0) near.add(old, now, static_cast<std::int32_t>(at));
    // The sum of squares is finite if all parts are finite, and small enough for the next step to recover.
    finite = hn::And(finite, dot(now, now) + dot(v, v) < infinite);
  }
  if constexpr (kContact) near.push_out(group);
  if (HWY_LIKELY(hn::AllTrue(Tag(), finite))) return;
  const Lanes broken = hn::IfThenElse(finite, all(0), all(1));
  HWY_ALIGN double flags[kWidth];
  store(broken, flags);
  for (std::size_t k = 0; k < kWidth; ++k)
    if (flags[k] != 0 && group.broke_at[lane + k] == 0) group.broke_at[lane + k] = step.step;
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
