// STAFF ONLY. Steps 1 to 3 of hair/head/full_head.h: forces, matrix, factorisation and solve in one sweep from the root to
// the tip, and one back. Everything is divided by the mass of a point within the strand. Row i of the equation is
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

// What is left of the matrix and the right-hand side: the rows of the points a, b, with the block (b, a).
struct Front {
  Sym3 aa, bb;
  Mat3 ba;
  Vec3 a, b;
};

// Rows of points that nothing follows have no such blocks.
HWY_INLINE void store_none(double* row, int from, int to) {
  for (int k = from; k < to; ++k) store(all(0), row + k * kWidth);
}

// x1 goes to `moved`, 3 numbers a point; `factor`: kFactorRow a point. `lane`: the first strand of these.
template <bool kBend>
HWY_NOINLINE void solve(const StepConstants& step, const Group& group, std::size_t lane, double* factor,
                        double* moved) {
  const int n = group.points;
  const double* const x = group.x + lane;
  const double* const v = group.v + lane;
  const auto row = [&](int i) { return factor + i * kFactorRow * kWidth; };

  Vec3 here = load3<kGroup>(x);
  const Vec3 root = placed(step.after, load3<kGroup>(group.root + lane));
  const Vec3 v0 = all(step.per_h) * (root - here);
  const Lanes rest_length = load(group.rest_length + lane), per_rest = reciprocal(rest_length);
  const Lanes stretch = all(step.stretch) * per_rest * per_rest, per_h = all(step.per_h);
  const Lanes bend = all(step.bend) * per_rest * per_rest;
  const Vec3 push = all3(step.push) - all(1 + step.drag) * v0;
  Which definite = all(0) == all(0);

  Segment before = endless(kBend ? turned(step.after.turn, load3<kGroup>(group.tangent + lane)) : zero3());
  Front f{diagonal(all(0)), diagonal(all(0)), zero33(), zero3(), zero3()};
  for (int s = 0; s < n - 1; ++s) {
    const Vec3 next = load3<kGroup>(x + 3 * (s + 1) * kGroup);
    const Lanes weight = all(s == n - 2 ? 0.5 : 1);
    const Segment segment = segment_along(next - here);
    const Stretch S(segment, rest_length, stretch);
    const Lanes pull = per_h * stretch * (segment.length - rest_length);

    // The rows of the segment's far end, c.
    Sym3 cc = diagonal(weight * all(step.mass));
    Vec3 c = minus(weight * (load3<kGroup>(v + 3 * (s + 1) * kGroup) + push), pull, segment.u);
    f.b = plus(f.b, pull, segment.u);
    if constexpr (kBend) {
      const Lanes k = s == 0 ? all(step.clamp) * per_rest * per_rest : bend;
      const Joint joint(before, segment, k, per_h, S);
      const Sym3& outer = joint.block22;
      const Mat3 &ca = joint.block21, minus_ca = zero33() - ca;
      f.aa = f.aa + joint.block11;
      f.ba = f.ba + (ca - full(joint.block11));
      f.bb = f.bb + joint.block11 + outer + Sym3{minus_ca.x.x + minus_ca.x.x, minus_ca.x.y + minus_ca.y.x,
                                                 minus_ca.y.y + minus_ca.y.y, minus_ca.x.z + minus_ca.z.x,
                                                 minus_ca.y.z + minus_ca.z.y, minus_ca.z.z + minus_ca.z.z};
      Mat3 cb = ca - full(outer);
      cc = cc + outer;
      f.a = plus(f.a, joint.pull1, joint.turn1);
      f.b = minus(plus(f.b, joint.pull2, joint.turn2), joint.pull1, joint.turn1);
      c = minus(c, joint.pull2, joint.turn2);
      if (s >= 2) {  // point a, s - 1, is complete; the root is not solved for
        const Pivot pivot(f.aa, f.a, definite);
        const Below near(f.ba, pivot), far(minus_ca, pivot);
        store33(near.factor, row(s - 1));
        store33(far.factor, row(s - 1) + 9 * kWidth);
        store_pivot(pivot, row(s - 1));
        take(near, pivot, f.bb, f.b);
        take(far, near, cb);
        take(far, pivot, cc, c);
      }
      f = {f.bb, cc, cb, f.b, c};
    } else {
      const Sym3 block = diagonal(S.across) + S.along * segment.uu;
      f.bb = f.bb + block;
      cc = cc + block;
      if (s >= 1) {  // point b, s, is complete
        const Pivot pivot(f.bb, f.b, definite);
        const Below near(zero33() - full(block), pivot);
        store33(near.factor, row(s));
        store_pivot(pivot, row(s));
        take(near, pivot, cc, c);
      }
      f.bb = cc;
      f.b = c;
    }
    here = next;
    before = segment;
  }
  if (kBend && n > 2) {
    const Pivot pivot(f.aa, f.a, definite);
    const Below near(f.ba, pivot);
    store33(near.factor, row(n - 2));
    store_none(row(n - 2), 9, 18);
    store_pivot(pivot, row(n - 2));
    take(near, pivot, f.bb, f.b);
  }
  store_none(row(n - 1), 0, 18);
  store_pivot(Pivot(f.bb, f.b, definite), row(n - 1));

  // A strand whose matrix is not definite gets no numbers.
  const Vec3 v0_or_nan =
      choose(definite, v0, all(std::numeric_limits<double>::quiet_NaN()) * all3(step.push));
  Vec3 near = zero3(), far = zero3();
  for (int i = n - 1; i > 0; --i) {
    Vec3 y = load3<kWidth>(row(i) + 21 * kWidth);
    substitute(row(i), near, y);
    if constexpr (kBend) substitute(row(i) + 9 * kWidth, far, y);
    y = back(row(i), y);
    store3<kWidth>(plus(load3<kGroup>(x + 3 * i * kGroup), all(step.h), v0_or_nan + y),
                   moved + 3 * i * kWidth);
    far = near;
    near = y;
  }
  store3<kWidth>(root, moved);
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
