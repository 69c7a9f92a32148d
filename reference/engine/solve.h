// STAFF ONLY. Steps 1 to 3 of hair/dense/full_head.h: forces, matrix, factorisation and solve; without
// bending in one sweep from the root to the tip, and one back. Everything is divided by the mass of a point
// within the strand. Row i of the equation is
//
//   (w_i mass + h^2 S_i / m) y = w_i (v_i - v0 + push - drag v0) + h f_i / m,   w = 1, at the tip 1/2.
#if defined(HAIR_REFERENCE_ENGINE_SOLVE_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_SOLVE_H_
#undef HAIR_REFERENCE_ENGINE_SOLVE_H_
#else
#define HAIR_REFERENCE_ENGINE_SOLVE_H_
#endif

#include <limits>

#include "reference/engine/front.h"
#include "reference/engine/springs.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

// The last rows lack these blocks, since no point follows: they are set to 0.
HWY_INLINE void store_none(double* row, int from, int to) {
  for (int k = from; k < to; ++k) store(all(0), row + k * kWidth);
}

// The data that all sweeps of a step use.
struct Sweep {
  int n;
  const double *x, *v;
  double* factor;
  Vec3 root, v0, push;
  Lanes rest_length, per_rest, stretch, bend;

  HWY_INLINE Sweep(const StepConstants& step, const Group& group, std::size_t lane, double* rows)
      : n(group.points), x(group.x + lane), v(group.v + lane), factor(rows) {
    root = Axes(step.after)(load3<kGroup>(group.root + lane));
    v0 = all(step.per_h) * (root - load3<kGroup>(x));
    push = all3(step.push) - all(1 + step.drag) * v0;
    rest_length = load(group.rest_length + lane);
    per_rest = reciprocal(rest_length);
    stretch = all(step.stretch) * per_rest * per_rest;
    bend = all(step.bend) * per_rest * per_rest;
  }

  HWY_INLINE Vec3 place(int i) const { return load3<kGroup>(x + 3 * i * kGroup); }
  HWY_INLINE double* row(int i) const { return factor + i * kFactorRow * kWidth; }
  // h f / m of a stretched segment, from its first end to the other.
  HWY_INLINE Lanes tension(const StepConstants& step, const Segment& segment) const {
    return all(step.per_h) * stretch * (segment.length - rest_length);
  }
  // The right-hand side of point i without springs.
  HWY_INLINE Vec3 momentum(int i) const {
    const Vec3 p = load3<kGroup>(v + 3 * i * kGroup) + push;
    return i == n - 1 ? all(0.5) * p : p;
  }
  HWY_INLINE Lanes mass(const StepConstants& step, int i) const {
    return all(i == n - 1 ? 0.5 * step.mass : step.mass);
  }
  // Fetches the next group's state, which follows this one's if it has as many points.
  HWY_INLINE void fetch_next(int i) const {
    const double* const next = x + (6 * n + 7) * kGroup;
    for (int k = 0; k < 6; ++k) __builtin_prefetch(next + (6 * i + k) * kGroup, 0, 2);
  }
};

// The sweep back, which computes y, and from it x1 in the place of the right-hand sides.
template <bool kBend>
HWY_INLINE void solve_back(const StepConstants& step, const Sweep& sweep, Which definite, double* moved) {
  // A strand whose matrix is not definite becomes NaN.
  const Vec3 v0 = choose(definite, sweep.v0, all(std::numeric_limits<double>::quiet_NaN()) * all3(step.push));
  Vec3 near = zero3(), far = zero3();
  for (int i = sweep.n - 1; i > 0; --i) {
    const double* const row = sweep.row(i);
    Vec3 y = load3<kWidth>(moved + 3 * i * kWidth);
    if constexpr (kBend) y = less_transposed(y, row + kFar * kWidth, far);
    y = back(row, less_transposed(y, row + kNear * kWidth, near));
    store3<kWidth>(plus(sweep.place(i), all(step.h), v0 + y), moved + 3 * i * kWidth);
    far = near;
    near = y;
  }
  store3<kWidth>(sweep.root, moved);
}

// Writes x1 to `moved`, 3 numbers a point. `factor` has kFactorRow numbers a point, and one row more. `lane`
// is the first strand's.
HWY_NOINLINE void solve_stretch(const StepConstants& step, const Group& group, std::size_t lane,
                                double* factor, double* moved) {
  const Sweep sweep(step, group, lane, factor);
  const int n = sweep.n;
  Which definite = all(0) == all(0);
  Vec3 here = sweep.place(0), b = zero3();
  Sym3 bb = diagonal(all(0));
  for (int s = 0; s < n - 1; ++s) {
    sweep.fetch_next(s);
    const Vec3 next = sweep.place(s + 1);
    const Segment segment = segment_along(next - here);
    const Lanes tension = sweep.tension(step, segment),
                across = stretch_across(segment, sweep.rest_length, sweep.stretch);
    const Sym3 block = diagonal(across) + (sweep.stretch - across) * square(segment.u);
    if (s >= 1) {  // point s is complete; the root is not solved for
      const Pivot pivot(bb + block, plus(b, tension, segment.u), definite);
      store_pivot(pivot, sweep.row(s), moved + 3 * s * kWidth);
      const Mat3 below = full(block);
      Vec3 ld[3], l[3];
      eliminate(
          pivot, [&](int k) { return k == 0   ? below.x
                                     : k == 1 ? below.y
                                              : below.z; }, ld,
          sweep.row(s) + kNear * kWidth, [&](int k, const Vec3& row) { l[k] = row; });
      bb = {less(block.xx, l[0], ld[0]), less(block.yx, l[1], ld[0]), less(block.yy, l[1], ld[1]),
            less(block.zx, l[2], ld[0]), less(block.zy, l[2], ld[1]), less(block.zz, l[2], ld[2])};
      b = {dot(l[0], pivot.rhs), dot(l[1], pivot.rhs), dot(l[2], pivot.rhs)};
    } else {
      bb = block;
    }
    bb = bb + diagonal(sweep.mass(step, s + 1));
    b = minus(b + sweep.momentum(s + 1), tension, segment.u);
    here = next;
  }
  store_none(sweep.row(n - 1), 0, 18);
  store_pivot(Pivot(bb, b, definite), sweep.row(n - 1), moved + 3 * (n - 1) * kWidth);
  solve_back<false>(step, sweep, definite, moved);
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
