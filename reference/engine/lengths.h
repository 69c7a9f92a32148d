// STAFF ONLY. Step 4 of hair/head/full_head.h: H5's correct_lengths for several strands, as the reference has it: Newton's
// method with a tridiagonal matrix, halved steps, and `place` where that fails. A strand's steps depend on no other strand:
// those that are done wait unchanged for the rest.
#if defined(HAIR_REFERENCE_ENGINE_LENGTHS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_LENGTHS_H_
#undef HAIR_REFERENCE_ENGINE_LENGTHS_H_
#else
#define HAIR_REFERENCE_ENGINE_LENGTHS_H_
#endif

#include <utility>

#include "reference/engine/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

inline constexpr int kMostNewtonSteps = 30, kMostLengthSteps = 100;
inline constexpr double kSmallestPart = 0x1p-10;

// Errors of the segments' lengths, relative to rest. NaN stays.
struct LengthErrors {
  Lanes largest, squared;

  HWY_INLINE void add(Lanes length, Lanes rest_length, Lanes per_rest) {
    const Lanes error = (length - rest_length) * per_rest;
    largest = hn::Max(largest, hn::Abs(error));
    squared = hn::MulAdd(error, error, squared);
  }
};

// Per segment six numbers: direction, the factor below the diagonal, the diagonal's reciprocal (then lambda), the length.
inline constexpr std::size_t kSegmentRow = 6;

class LengthCorrection {
 public:
  HWY_INLINE LengthCorrection(int points, Lanes rest_length, const Vec3& tangent, double* rows)
      : n_(points), rest_(rest_length), per_rest_(all(1) / rest_length), tangent_(tangent), rows_(rows) {}

  HWY_INLINE LengthErrors measure(const double* x) {
    LengthErrors errors{all(0), all(0)};
    Vec3 here = load3<kWidth>(x);
    for (int i = 0; i < n_ - 1; ++i) {
      const Vec3 next = load3<kWidth>(x + 3 * (i + 1) * kWidth), e = next - here;
      const Lanes length = hn::Sqrt(dot(e, e));
      store(length, row(i) + 5 * kWidth);
      errors.add(length, rest_, per_rest_);
      here = next;
    }
    return errors;
  }

  // The multipliers of the Newton step at x, whose lengths were measured last. Weights are 1/mass: 0 of the root, 2 of the tip.
  HWY_INLINE void factor(const double* x) {
    Vec3 here = load3<kWidth>(x), before = tangent_;
    Lanes q = all(0), reciprocal = all(0), lambda = all(0);
    for (int i = 0; i < n_ - 1; ++i) {
      const Vec3 next = load3<kWidth>(x + 3 * (i + 1) * kWidth);
      const Lanes length = load(row(i) + 5 * kWidth);
      const Vec3 u = choose(length > all(0), (all(1) / length) * (next - here), before);
      Lanes below = all(0);
      if (i > 0) {
        const Vec3 c = cross(before, u);
        below = all(0) - dot(before, u) * reciprocal;
        q = (q + dot(c, c)) * reciprocal;
      }
      reciprocal = all(1) / (all(i == n_ - 2 ? 2 : 1) + q);
      lambda = hn::NegMulAdd(below, lambda, rest_ - length);
      store3<kWidth>(u, row(i));
      store(below, row(i) + 3 * kWidth);
      store(lambda * reciprocal, row(i) + 4 * kWidth);
      here = next;
      before = u;
    }
    for (int i = n_ - 3; i >= 0; --i) {
      lambda = load(row(i + 1) + 4 * kWidth);
      store(hn::NegMulAdd(load(row(i + 1) + 3 * kWidth), lambda, load(row(i) + 4 * kWidth)),
            row(i) + 4 * kWidth);
    }
  }

  // tried = x + part W J^T lambda where `active`, x elsewhere; measures it.
  HWY_INLINE LengthErrors attempt(const double* x, Lanes part, Which active, double* tried) {
    LengthErrors errors{all(0), all(0)};
    Vec3 here = load3<kWidth>(x), inner = load(row(0) + 4 * kWidth) * load3<kWidth>(row(0));
    store3<kWidth>(here, tried);
    for (int i = 0; i < n_ - 1; ++i) {
      const bool tip = i == n_ - 2;
      const Vec3 outer = tip ? zero3() : load(row(i + 1) + 4 * kWidth) * load3<kWidth>(row(i + 1));
      const Vec3 old = load3<kWidth>(x + 3 * (i + 1) * kWidth);
      const Lanes weighted = tip ? part + part : part;
      const Vec3 next = choose(active, plus(old, weighted, inner - outer), old), e = next - here;
      const Lanes length = hn::Sqrt(dot(e, e));
      store3<kWidth>(next, tried + 3 * (i + 1) * kWidth);
      store(length, row(i) + 5 * kWidth);
      errors.add(length, rest_, per_rest_);
      here = next;
      inner = outer;
    }
    return errors;
  }

  // Each point at its distance from the one before, towards where it was; where `which`.
  HWY_INLINE void place(const double* x, Which which, double* to) {
    Vec3 here = load3<kWidth>(x), u = tangent_;
    for (int i = 0; i < n_ - 1; ++i) {
      double* const at = to + 3 * (i + 1) * kWidth;
      const Vec3 old = load3<kWidth>(x + 3 * (i + 1) * kWidth), e = old - here;
      const Lanes length = hn::Sqrt(dot(e, e));
      u = choose(length > all(0), (all(1) / length) * e, u);
      here = plus(here, rest_, u);
      store3<kWidth>(choose(which, here, load3<kWidth>(at)), at);
    }
  }

 private:
  HWY_INLINE double* row(int i) { return rows_ + i * kSegmentRow * kWidth; }

  int n_;
  Lanes rest_, per_rest_;
  Vec3 tangent_;
  double* rows_;
};

// Corrects x; `other`: as many numbers. Returns the one of the two that holds the result.
HWY_NOINLINE double* correct_lengths(const StepConstants& step, const Group& group, std::size_t lane,
                                     double* rows, double* x, double* other) {
  const Lanes rest = load(group.rest_length + lane);
  const Vec3 root = load3<kWidth>(x);
  const Vec3 tangent = turned(step.after.turn, load3<kGroup>(group.tangent + lane));
  LengthCorrection strands(group.points, rest, tangent, rows);

  // H5's bound for what rounding allows, with |x_i| at most |root| + L once the lengths are right.
  const Lanes reach = hn::Max(hn::Abs(root.x), hn::Max(hn::Abs(root.y), hn::Abs(root.z)));
  const Lanes rounding = all(0x1p-51) * (reach / rest + all(group.points - 1));
  const Lanes goal = hn::Max(all(step.length_tolerance), rounding), infinite = hn::Inf(Tag());

  LengthErrors errors = strands.measure(x);
  for (int steps = 1; steps <= kMostLengthSteps; ++steps) {
    Which active = hn::And(errors.largest > goal, errors.squared < infinite);
    if (hn::AllFalse(Tag(), active)) return x;
    strands.factor(x);
    Lanes part = all(1);
    const Lanes before = errors.squared;
    Which failed = hn::Not(active);
    for (;;) {
      errors = strands.attempt(x, part, active, other);
      failed = hn::AndNot(errors.squared < before, active);
      const Which halve = hn::And(failed, part > all(kSmallestPart));
      if (HWY_LIKELY(hn::AllFalse(Tag(), halve))) break;
      part = hn::IfThenElse(halve, all(0.5) * part, part);
    }
    if (HWY_UNLIKELY(steps > kMostNewtonSteps)) failed = active;
    if (HWY_UNLIKELY(!hn::AllFalse(Tag(), failed))) {
      strands.place(x, failed, other);
      errors = strands.measure(other);
      errors.largest = hn::IfThenZeroElse(failed, errors.largest);  // done
    }
    std::swap(x, other);
  }
  return x;
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
