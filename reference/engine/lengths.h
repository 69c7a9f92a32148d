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

// Per segment nine numbers: its direction and length, as measured last; of the Newton step the factor below the diagonal,
// lambda, and lambda times the direction.
inline constexpr std::size_t kSegmentRow = 9;

class LengthCorrection {
 public:
  HWY_INLINE LengthCorrection(int points, Lanes rest_length, const Vec3& tangent, double* rows)
      : n_(points), rest_(rest_length), per_rest_(reciprocal(rest_length)), tangent_(tangent), rows_(rows) {}

  HWY_INLINE LengthErrors measure(const double* x) {
    LengthErrors errors{all(0), all(0)};
    Vec3 here = load3<kWidth>(x);
    for (int i = 0; i < n_ - 1; ++i) {
      const Vec3 next = load3<kWidth>(x + 3 * (i + 1) * kWidth);
      measure_segment(i, next - here, errors);
      here = next;
    }
    return errors;
  }

  // The Newton step of the state that was measured last. Weights are 1/mass: 0 of the root, 2 of the tip.
  HWY_INLINE void factor() {
    Vec3 before = tangent_;
    Lanes q = all(0), per_d = all(0), lambda = all(0);
    for (int i = 0; i < n_ - 1; ++i) {
      const Lanes length = load(row(i) + 3 * kWidth);
      const Vec3 u = choose(length > all(0), load3<kWidth>(row(i)), before);
      Lanes below = all(0);
      if (i > 0) {
        const Vec3 c = cross(before, u);
        below = all(0) - dot(before, u) * per_d;
        q = (q + dot(c, c)) * per_d;
      }
      per_d = reciprocal(all(i == n_ - 2 ? 2 : 1) + q);
      lambda = hn::NegMulAdd(below, lambda, rest_ - length);
      store3<kWidth>(u, row(i));
      store(below, row(i) + 4 * kWidth);
      store(lambda * per_d, row(i) + 5 * kWidth);
      before = u;
    }
    lambda = all(0);
    Lanes below = all(0);
    for (int i = n_ - 2; i >= 0; --i) {
      lambda = hn::NegMulAdd(below, lambda, load(row(i) + 5 * kWidth));
      below = load(row(i) + 4 * kWidth);
      store3<kWidth>(lambda * load3<kWidth>(row(i)), row(i) + 6 * kWidth);
    }
  }

  // tried = x + part W J^T lambda where `active`, x elsewhere; measures it.
  HWY_INLINE LengthErrors attempt(const double* x, Lanes part, Which active, double* tried) {
    LengthErrors errors{all(0), all(0)};
    Vec3 here = load3<kWidth>(x), inner = load3<kWidth>(row(0) + 6 * kWidth);
    store3<kWidth>(here, tried);
    for (int i = 0; i < n_ - 1; ++i) {
      const bool tip = i == n_ - 2;
      const Vec3 outer = tip ? zero3() : load3<kWidth>(row(i + 1) + 6 * kWidth);
      const Vec3 old = load3<kWidth>(x + 3 * (i + 1) * kWidth);
      const Lanes weight = tip ? part + part : part;
      const Vec3 next = choose(active, plus(old, weight, inner - outer), old);
      store3<kWidth>(next, tried + 3 * (i + 1) * kWidth);
      measure_segment(i, next - here, errors);
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
      const Length length = length_of(e);
      u = choose(length.value > all(0), length.reciprocal * e, u);
      here = plus(here, rest_, u);
      store3<kWidth>(choose(which, here, load3<kWidth>(at)), at);
    }
  }

 private:
  HWY_INLINE void measure_segment(int i, const Vec3& e, LengthErrors& errors) {
    const Length length = length_of(e);
    store3<kWidth>(length.reciprocal * e, row(i));
    store(length.value, row(i) + 3 * kWidth);
    errors.add(length.value, rest_, per_rest_);
  }
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
    strands.factor();
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
