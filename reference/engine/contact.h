// STAFF ONLY. Steps 5 and 6 of hair/head/full_head.h: velocities, the head, and the way back to memory.
#if defined(HAIR_REFERENCE_ENGINE_CONTACT_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_CONTACT_H_
#undef HAIR_REFERENCE_ENGINE_CONTACT_H_
#else
#define HAIR_REFERENCE_ENGINE_CONTACT_H_
#endif

#include "reference/engine/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

inline constexpr int kMostPushes = 20;

struct HeadSurface {
  Lanes depth;  // m, > 0 inside; 0 beyond the grid
  Vec3 normal;  // of length 1 where depth > 0
};

// Of a point that is known to be near, the table of bits is not asked.
template <bool kNear>
HWY_INLINE HeadSurface head_surface(const GridView& grid, const Vec3& point) {
  const hn::Rebind<std::int32_t, Tag> integers;
  const hn::Rebind<float, Tag> floats;
  const Vec3 cell = all(grid.per_cell) * (point - all3(grid.low));
  const auto last = [&](int axis) { return all(grid.count[axis] - 1); };
  const Which on_grid = hn::And(
      hn::And(hn::And(cell.x >= all(0), cell.x < last(0)), hn::And(cell.y >= all(0), cell.y < last(1))),
      hn::And(cell.z >= all(0), cell.z < last(2)));
  HeadSurface surface{all(0), zero3()};
  if (hn::AllFalse(Tag(), on_grid)) return surface;
  const Vec3 inside = choose(on_grid, cell, zero3());
  const Vec3 low{hn::Floor(inside.x), hn::Floor(inside.y), hn::Floor(inside.z)}, t = inside - low;
  const auto index = hn::DemoteTo(
      integers, hn::MulAdd(hn::MulAdd(low.z, all(grid.count[1]), low.y), all(grid.count[0]), low.x));
  if constexpr (!kNear) {
    const auto word = hn::GatherIndex(integers, grid.reaches_inside, hn::ShiftRight<5>(index));
    const auto bit = hn::And(word >> hn::And(index, hn::Set(integers, 31)), hn::Set(integers, 1));
    if (hn::AllFalse(integers, bit != hn::Zero(integers))) return surface;
  }
  const auto corner = [&](int di, int dj, int dk) {
    const float* const from = grid.distance + (dk * grid.count[1] + dj) * grid.count[0] + di;
    return hn::PromoteTo(Tag(), hn::GatherIndex(floats, from, index));
  };
  const Lanes c000 = corner(0, 0, 0), c100 = corner(1, 0, 0), c010 = corner(0, 1, 0), c110 = corner(1, 1, 0),
              c001 = corner(0, 0, 1), c101 = corner(1, 0, 1), c011 = corner(0, 1, 1), c111 = corner(1, 1, 1);
  const auto mix = [](Lanes a, Lanes b, Lanes s) { return hn::MulAdd(s, b - a, a); };
  const Lanes c00 = mix(c000, c100, t.x), c10 = mix(c010, c110, t.x), c01 = mix(c001, c101, t.x),
              c11 = mix(c011, c111, t.x), c0 = mix(c00, c10, t.y), c1 = mix(c01, c11, t.y);
  const Lanes distance = mix(c0, c1, t.z);
  surface.depth = hn::IfThenElseZero(on_grid, hn::Max(all(0) - distance, all(0)));
  if (hn::AllFalse(Tag(), surface.depth > all(0))) return surface;
  const Vec3 gradient{mix(mix(c100 - c000, c110 - c010, t.y), mix(c101 - c001, c111 - c011, t.y), t.z),
                      mix(c10 - c00, c11 - c01, t.z), c1 - c0};
  const Lanes per_slope = length_of(gradient).reciprocal;
  surface.normal = per_slope * gradient;
  // The gradient is one of differences between grid points: times `per_cell` it is one of metres.
  surface.depth = surface.depth * hn::Min(per_slope * all(1 / grid.per_cell), all(1 / kLeastSlope));
  return surface;
}

// What friction takes from a vector: its part across n, at most `limit` of it.
HWY_INLINE Vec3 friction(const Vec3& vector, const Vec3& n, Lanes limit) {
  const Vec3 across = minus(vector, dot(n, vector), n);
  return hn::Min(all(1), limit * length_of(across).reciprocal) * across;
}

// Pushes points out that are inside; `old`: where they were before the step.
HWY_INLINE void push_out(const StepConstants& step, const Vec3& old, Vec3& x, Vec3& v) {
  Vec3 p = turned_back(step.after.turn, x - all3(step.after.at));
  HeadSurface surface = head_surface<false>(step.grid, p);
  Which inside = surface.depth > all(0);
  if (hn::AllFalse(Tag(), inside)) return;
  const Vec3 p_old = turned_back(step.before.turn, old - all3(step.before.at));
  const Lanes mu = all(step.friction);
  // The velocity beside the head's, in the head's axes.
  Vec3 u = all(step.per_h) * (p - p_old);
  const Vec3 u_before = u;
  const Which any = inside;
  for (int push = 0; push < kMostPushes; ++push) {
    const Vec3& n = surface.normal;
    const Vec3 moved = plus(p, surface.depth, n) - friction(p - p_old, n, mu * surface.depth);
    p = choose(inside, moved, p);
    const Lanes speed = hn::Max(all(0) - dot(n, u), all(0));
    u = choose(inside, plus(u, speed, n) - friction(u, n, mu * speed), u);
    // After a short push, Newton's next error is less than the depth asked for: a grid's cells differ in slope by less than a
    // tenth. Whether a strand is done depends on no other.
    inside = hn::And(inside, surface.depth > all(10 * step.contact_depth));
    if (hn::AllFalse(Tag(), inside)) break;
    surface = head_surface<true>(step.grid, p);
    inside = hn::And(inside, surface.depth > all(step.contact_depth));
    if (hn::AllFalse(Tag(), inside)) break;
  }
  x = choose(any, turned(step.after.turn, p) + all3(step.after.at), x);
  v = choose(any, v + turned(step.after.turn, u - u_before), v);
}

template <bool kContact>
HWY_NOINLINE void finish(const StepConstants& step, const Group& group, std::size_t lane,
                         const double* moved) {
  Which finite = all(0) == all(0);
  const Lanes infinite = hn::Inf(Tag());
  for (int i = 0; i < group.points; ++i) {
    double* const x = group.x + lane + 3 * i * kGroup;
    const Vec3 old = load3<kGroup>(x);
    Vec3 now = load3<kWidth>(moved + 3 * i * kWidth);
    Vec3 v = all(step.per_h) * (now - old);
    if constexpr (kContact)
      if (i > 0) push_out(step, old, now, v);
    store3<kGroup>(now, x);
    store3<kGroup>(v, group.v + lane + 3 * i * kGroup);
    // A sum of squares is finite if its parts are, and not too large for a step to come back from.
    finite = hn::And(finite, dot(now, now) + dot(v, v) < infinite);
  }
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
