// STAFF ONLY. Steps 1 to 3 of hair/dense/full_head.h with bending. Three sweeps measure segments and
// joints and store the matrix; their points do not wait for each other. A fourth eliminates, and one goes
// back.
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

#include "reference/engine/solve.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

HWY_INLINE Sym3 load_own(const double* row) {
  const Vec3 a = load3<kWidth>(row + kOwn * kWidth), b = load3<kWidth>(row + (kOwn + 3) * kWidth);
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
HWY_INLINE void store_own(const Sym3& a, double* row) {
  store3<kWidth>({a.xx, a.yx, a.yy}, row + kOwn * kWidth);
  store3<kWidth>({a.zx, a.zy, a.zz}, row + (kOwn + 3) * kWidth);
}

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

// Replaces the numbers of segments and joints by the matrix, and stores the right-hand sides. Blocks pass
// through memory, since 16 registers can't hold them beside an elimination.
HWY_NOINLINE void store_matrix(const StepConstants& step, const Sweep& sweep, Vec3 u_before, double* rhs) {
  Vec3 force_before = zero3();
  for (int s = 0; s < sweep.n - 1; ++s) {
    double *const row = sweep.row(s), *const next_row = sweep.row(s + 1);
    const auto at = [&](std::size_t k) { return load(next_row + k * kWidth); };
    const auto after = [&](std::size_t k) { return load(next_row + (k + kFactorRow) * kWidth); };
    const Vec3 u{at(kU), at(kU + 1), at(kU + 2)}, u_next{after(kU), after(kU + 1), after(kU + 2)};
    const Vec3 c{at(kC), at(kC + 1), at(kC + 2)}, c_next{after(kC), after(kC + 1), after(kC + 2)};
    const Lanes per_length = at(kPerLength);

    const Lanes q = at(kQ) * per_length, q_next = after(kQ) * per_length;
    const Lanes along = at(kTension) + hn::MulAdd(q, dot(u_before, u), q_next * dot(u, u_next));
    const Vec3 force = minus(minus(along * u, q, u_before), q_next, u_next);
    store3<kWidth>(sweep.momentum(s) + (force - force_before), rhs + 3 * s * kWidth);
    u_before = u;
    force_before = force;

    const Lanes k = (at(kK) + after(kK)) * per_length * per_length, across = at(kAcross) + k;
    const Sym3 own = plus(plus(plus(diagonal(across), (sweep.stretch - across) * u, u),
                               (all(0) - at(kS) * per_length * per_length) * c, c),
                          (all(0) - after(kS) * per_length * per_length) * c_next, c_next);

    const Lanes both = per_length * after(kPerLength), straight = both * after(kCos);
    const Vec3 kc = both * after(kK) * c_next, ku = both * after(kK) * u_next,
               tc = both * after(kSR) * c_next;
    // Rows of -(cos 1 + [c]x) k + k (s - r) c c^T + k u2 u1^T.
    const Mat3 x{plus({hn::MulSub(tc.x, c_next.x, straight), hn::MulAdd(tc.x, c_next.y, kc.z),
                       hn::MulSub(tc.x, c_next.z, kc.y)},
                      ku.x, u),
                 plus({hn::MulSub(tc.y, c_next.x, kc.z), hn::MulSub(tc.y, c_next.y, straight),
                       hn::MulAdd(tc.y, c_next.z, kc.x)},
                      ku.y, u),
                 plus({hn::MulAdd(tc.z, c_next.x, kc.y), hn::MulSub(tc.z, c_next.y, kc.x),
                       hn::MulSub(tc.z, c_next.z, straight)},
                      ku.z, u)};
    const Lanes mass = sweep.mass(step, s + 1);
    store_own({mass + own.xx - (x.x.x + x.x.x), own.yx - (x.x.y + x.y.x), mass + own.yy - (x.y.y + x.y.y),
               own.zx - (x.x.z + x.z.x), own.zy - (x.y.z + x.z.y), mass + own.zz - (x.z.z + x.z.z)},
              next_row);
    store33(x, row + kFar * kWidth);
    if (s == 0) continue;  // the root is not solved for
    store_own(load_own(row) + own, row);
    const Mat3 x_before = load33(sweep.row(s - 1) + kFar * kWidth);
    store33(full(own) - (x_before + x), row + kNear * kWidth);
  }
  store3<kWidth>(sweep.momentum(sweep.n - 1) - force_before, rhs + 3 * (sweep.n - 1) * kWidth);
}

HWY_NOINLINE void solve_bending(const StepConstants& step, const Group& group, std::size_t lane,
                                double* factor, double* moved) {
  const Sweep sweep(step, group, lane, factor);
  const int n = sweep.n;
  Which definite = all(0) == all(0);
  // A segment's numbers are in the row of its far end, which the factor overwrites later.
  const Vec3 tangent = turned(step.after.turn, load3<kGroup>(group.tangent + lane));
  store_none(sweep.row(n), 0, kFactorRow);
  measure_segments(step, sweep);
  measure_joints(step, sweep, tangent);
  store_matrix(step, sweep, tangent, moved);

  for (int i = 1;; ++i) {
    sweep.fetch_next(i);
    double *const row = sweep.row(i), *const next = sweep.row(i + 1), *const rhs = moved + 3 * i * kWidth;
    const Pivot pivot(load_own(row), load3<kWidth>(rhs), definite);
    store_pivot(pivot, row, rhs);
    if (i == n - 1) break;
    // Takes an elimination's part from a row and a right-hand side that are `ahead` of this one.
    const auto take = [&](int ahead, int k, const Vec3& l, const Vec3(&scaled)[3]) {
      for (int j = 0; j <= k; ++j) {
        double* const own = row + (ahead * kFactorRow + kOwn + k * (k + 1) / 2 + j) * kWidth;
        store(less(load(own), l, scaled[j]), own);
      }
      double* const b = rhs + (3 * ahead + k) * kWidth;
      store(more(load(b), l, pivot.rhs), b);
    };
    const auto block = [&](std::size_t at) {
      return [&, at](int k) { return load3<kWidth>(row + (at + 3 * k) * kWidth); };
    };
    Vec3 near[3], far[3];
    eliminate(pivot, block(kNear), near, row + kNear * kWidth,
              [&](int k, const Vec3& l) { take(1, k, l, near); });
    if (i == n - 2) continue;
    eliminate(pivot, block(kFar), far, row + kFar * kWidth, [&](int k, const Vec3& l) {
      double* const with = next + (kNear + 3 * k) * kWidth;
      for (int j = 0; j < 3; ++j) store(more(load(with + j * kWidth), l, near[j]), with + j * kWidth);
      take(2, k, l, far);
    });
  }
  store_none(sweep.row(n - 1), 0, kOwn);
  solve_back<true>(step, sweep, definite, moved);
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
