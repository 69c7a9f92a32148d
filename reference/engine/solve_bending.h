// STAFF ONLY. Steps 1 to 3 of hair/dense/full_head.h with bending. Two sweeps measure segments and joints,
// whose points do not wait for each other; a third eliminates, and one goes back.
//
// The energy depends on the segments' vectors e. With its second derivatives H_ss and X_s = H_{s+1,s}, point
// i between the segments i - 1 and i has
//
//   A_ii = m + H_{i-1,i-1} + H_ii - X_{i-1} - X_{i-1}^T,
//   A_{i+1,i} = X_{i-1} + X_i - H_ii,   A_{i+2,i} = -X_i,
//
// and the force dE/de_i - dE/de_{i-1}.
#if defined(HAIR_REFERENCE_ENGINE_SOLVE_BENDING_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_SOLVE_BENDING_H_
#undef HAIR_REFERENCE_ENGINE_SOLVE_BENDING_H_
#else
#define HAIR_REFERENCE_ENGINE_SOLVE_BENDING_H_
#endif

#include <algorithm>

#include "reference/engine/solve.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

// A segment's part of the matrix and of the right-hand side: dE/de, and the second derivatives by e twice,
// and by the next segment's e and e.
struct SegmentBlocks {
  Vec3 force;
  Sym3 own;
  Mat3 next;

  // `row` is the segment's row; the next one's follows it.
  HWY_INLINE SegmentBlocks(const Vec3& u_before, const double* row, Lanes stretch) {
    constexpr std::size_t kNext = kFactorRow * kWidth;
    const auto at = [&](std::size_t k) { return load(row + k * kWidth); };
    const auto after = [&](std::size_t k) { return load(row + k * kWidth + kNext); };
    const Vec3 u = load3<kWidth>(row + kU * kWidth), u_next = load3<kWidth>(row + kU * kWidth + kNext);
    const Vec3 c = load3<kWidth>(row + kC * kWidth), c_next = load3<kWidth>(row + kC * kWidth + kNext);
    const Lanes per_length = at(kPerLength);

    const Lanes q = at(kQ) * per_length, q_next = after(kQ) * per_length;
    const Lanes along = at(kTension) + hn::MulAdd(q, dot(u_before, u), q_next * dot(u, u_next));
    force = minus(minus(along * u, q, u_before), q_next, u_next);

    const Lanes k = (at(kK) + after(kK)) * per_length * per_length, across = at(kAcross) + k;
    own = plus(plus(plus(diagonal(across), (stretch - across) * u, u),
                    (all(0) - at(kS) * per_length * per_length) * c, c),
               (all(0) - after(kS) * per_length * per_length) * c_next, c_next);

    const Lanes both = per_length * after(kPerLength), straight = both * after(kCos);
    const Vec3 kc = both * after(kK) * c_next, ku = both * after(kK) * u_next,
               tc = both * after(kSR) * c_next;
    // Columns of -(cos 1 + [c]x) k + k (s - r) c c^T + k u2 u1^T.
    next.x = plus({hn::MulSub(tc.x, c_next.x, straight), hn::MulSub(tc.y, c_next.x, kc.z),
                   hn::MulAdd(tc.z, c_next.x, kc.y)},
                  u.x, ku);
    next.y = plus({hn::MulAdd(tc.x, c_next.y, kc.z), hn::MulSub(tc.y, c_next.y, straight),
                   hn::MulSub(tc.z, c_next.y, kc.x)},
                  u.y, ku);
    next.z = plus({hn::MulSub(tc.x, c_next.z, kc.y), hn::MulAdd(tc.y, c_next.z, kc.x),
                   hn::MulSub(tc.z, c_next.z, straight)},
                  u.z, ku);
  }
};

HWY_NOINLINE void measure_segments(const StepConstants& step, const Sweep& sweep) {
  Vec3 here = sweep.place(0);
  for (int s = 0; s < sweep.n - 1; ++s) {
    const Vec3 next = sweep.place(s + 1);
    const Segment segment = segment_along(next - here);
    double* const row = sweep.row(s + 1);
    store3<kWidth>(segment.u, row + kU * kWidth);
    store(segment.per_length, row + kPerLength * kWidth);
    store(sweep.tension(step, segment), row + kTension * kWidth);
    store(stretch_across(segment, sweep.rest_length, sweep.stretch), row + kAcross * kWidth);
    here = next;
  }
}
HWY_NOINLINE void measure_joints(const StepConstants& step, const Sweep& sweep, const Vec3& tangent) {
  Vec3 before = tangent;
  Lanes k = all(step.clamp) * sweep.per_rest * sweep.per_rest;
  for (int s = 0; s < sweep.n - 1; ++s) {
    double* const row = sweep.row(s + 1);
    const Vec3 u = load3<kWidth>(row + kU * kWidth);
    store_joint(before, u, k, all(step.per_h), row);
    before = u;
    k = sweep.bend;
  }
}

HWY_NOINLINE void solve_bending(const StepConstants& step, const Group& group, std::size_t lane,
                                double* factor, double* moved) {
  const Sweep sweep(step, group, lane, factor);
  const int n = sweep.n;
  Which definite = all(0) == all(0);
  // A segment's numbers are in the row of its far end, which the factor overwrites later.
  const Vec3 tangent = turned(step.after.turn, load3<kGroup>(group.tangent + lane));
  store_none(sweep.row(n), 0, kSegmentNumbers);
  measure_segments(step, sweep);
  measure_joints(step, sweep, tangent);

  // The segments on both sides of a point.
  const auto direction = [&](int s) { return load3<kWidth>(sweep.row(s + 1) + kU * kWidth); };
  SegmentBlocks before(tangent, sweep.row(1), sweep.stretch), segment = before;
  if (n > 2) segment = SegmentBlocks(direction(0), sweep.row(2), sweep.stretch);
  // The eliminations' part of the rows of the point (own block, right-hand side) and of the next one (also
  // its block with the point).
  Sym3 own = diagonal(all(0)), next_own = diagonal(all(0));
  Mat3 next_with = zero33();
  Vec3 b = zero3(), next_b = zero3();
  for (int i = 1; i < n - 1; ++i) {
    sweep.fetch_next(i);
    const Mat3 inner = full(segment.own) - before.next;
    const Mat3& x = before.next;
    // The results of earlier eliminations are added last, so that the other sums need not wait for them.
    const Lanes mass = sweep.mass(step, i);
    const Sym3 a{before.own.xx + mass + (inner.x.x - x.x.x), before.own.yx + (inner.x.y - x.y.x),
                 before.own.yy + mass + (inner.y.y - x.y.y), before.own.zx + (inner.x.z - x.z.x),
                 before.own.zy + (inner.y.z - x.z.y),        before.own.zz + mass + (inner.z.z - x.z.z)};
    const Pivot pivot(own + a, b + (sweep.momentum(i) + (segment.force - before.force)), definite);
    before = segment;
    // The next segment's blocks do not wait for the pivot, whose chain of operations is long. After the last
    // segment they are its own once more, and not used.
    segment = SegmentBlocks(direction(std::min(i, n - 3)), sweep.row(std::min(i + 2, n - 1)), sweep.stretch);
    const Below near(next_with + (before.next - inner), pivot), minus_far(before.next, pivot);
    store33(near.factor, sweep.row(i));
    store33(minus_far.factor, sweep.row(i) + 9 * kWidth);
    store_pivot(pivot, sweep.row(i), moved + 3 * i * kWidth);
    own = next_own;
    take(near, own);
    next_own = diagonal(all(0));
    take(minus_far, next_own);
    next_with = product(minus_far, near);
    b = next_b - product(near, pivot);
    next_b = product(minus_far, pivot);
  }
  store_none(sweep.row(n - 1), 0, 18);
  store_pivot(Pivot(own + before.own + diagonal(sweep.mass(step, n - 1)),
                    b + sweep.momentum(n - 1) - before.force, definite),
              sweep.row(n - 1), moved + 3 * (n - 1) * kWidth);
  solve_back<true>(step, sweep, definite, moved);
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
