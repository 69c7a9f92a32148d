// STAFF ONLY. Step 4 of hair/dense/full_head.h: H5's correct_lengths for several strands, as in the
// reference: Newton's method with a tridiagonal matrix, halved steps, and `place` where that fails. A
// strand's steps depend on no other strand: strands that are done wait unchanged for the rest.
//
// A Newton step is one sweep along the strand. At each segment it solves for the multiplier, moves a point,
// measures the segment, and eliminates it from the next step's matrix. An elimination ends where the solve
// with it has to begin, so sweeps go to the tip and to the root in turn.
//
// With the weights w = 1/mass (0 of the root, 2 of the tip) and c, s the cosine and sine of the angle of two
// neighbours, the matrix has w_i + w_{i+1} on its diagonal and -c beside it. Elimination leaves the pivots d
// = w' + q, where w' is the weight of a segment's far end:
//
//   q_0 = w of the first end,   q_k = 1 - c_k^2 / (1 + q_{k-1}) = (q_{k-1} + s_k^2) / d_{k-1}.
//
// That is a chain of divisions. With the products P_k = d_0 ... d_k, and G_k = q_k P_{k-1}, it becomes a
// chain of sums,
//
//   G_k = G_{k-1} + s_k^2 P_{k-2},   P_k = w' P_{k-1} + G_k,   1 / d_k = P_{k-1} / P_k.
#if defined(HAIR_REFERENCE_ENGINE_LENGTHS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_LENGTHS_H_
#undef HAIR_REFERENCE_ENGINE_LENGTHS_H_
#else
#define HAIR_REFERENCE_ENGINE_LENGTHS_H_
#endif

#include <cstddef>
#include <utility>

#include "reference/engine/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

inline constexpr int kMostNewtonSteps = 30, kMostLengthSteps = 100;
inline constexpr double kSmallestPart = 0x1p-10;

// Errors of the segments' lengths, relative to rest. NaN stays.
struct LengthErrors {
  Lanes largest, squared;
};

// Positions, and five numbers a segment: its direction along the sweep that measured it, and for the solve y
// / d and the c / d of the segment before it in the sweep.
inline constexpr std::size_t kSegmentRow = 5;
struct MeasuredStrands {
  double *x, *rows;
};

class LengthCorrection {
 public:
  HWY_INLINE LengthCorrection(int points, Lanes rest_length, const Vec3& tangent)
      : last_(points - 1), rest_(rest_length), per_rest_(reciprocal(rest_length)), tangent_(tangent) {}

  // Measures x.
  HWY_INLINE LengthErrors measure(bool to_tip, const MeasuredStrands& strands) const {
    return to_tip ? sweep<true, false>(strands, strands, all(0))
                  : sweep<false, false>(strands, strands, all(0));
  }

  // Prepares the measured strands for an attempt.
  HWY_INLINE void eliminate(bool to_tip, const MeasuredStrands& strands) const {
    return to_tip ? eliminate_along<true>(strands.rows) : eliminate_along<false>(strands.rows);
  }

  // Sets x of `to` to x + part W J^T lambda, and measures it. `from` was measured by a sweep the other way.
  HWY_INLINE LengthErrors attempt(bool to_tip, const MeasuredStrands& from, Lanes part,
                                  const MeasuredStrands& to) const {
    return to_tip ? sweep<true, true>(from, to, part) : sweep<false, true>(from, to, part);
  }

  // Puts each point at its distance from the one before, in its old direction, in the lanes `which`.
  HWY_INLINE void place(const double* x, Which which, double* to) const {
    Vec3 here = load3<kWidth>(x), u = tangent_;
    for (int i = 0; i < last_; ++i) {
      double* const at = to + 3 * (i + 1) * kWidth;
      const Vec3 old = load3<kWidth>(x + 3 * (i + 1) * kWidth), e = old - here;
      const Length length = length_of(e);
      u = choose(length.value > all(0), length.reciprocal * e, u);
      here = plus(here, rest_, u);
      store3<kWidth>(choose(which, here, load3<kWidth>(at)), at);
    }
  }

 private:
  // Points and segments count along the sweep.
  template <bool kToTip, bool kMove>
  HWY_NOINLINE LengthErrors sweep(MeasuredStrands from, MeasuredStrands to, Lanes part) const {
    // The ways from a point, and from a segment's row, to the next one.
    constexpr std::ptrdiff_t kWay = kToTip ? 1 : -1, kPoint = 3 * kWay * kWidth,
                             kRow = kWay * kSegmentRow * kWidth;
    const int last = last_;
    if (!kToTip)
      for (MeasuredStrands* const end : {&from, &to}) {
        end->x -= last * kPoint;
        end->rows -= (last - 1) * kRow;
      }
    constexpr double kFirstWeight = kToTip ? 0 : 2, kLastWeight = kToTip ? 2 : 0;
    LengthErrors errors{all(0), all(0)};

    Vec3 here = load3<kWidth>(from.x), pull = zero3();
    Lanes lambda = all(0);
    if constexpr (kMove) {
      lambda = load(from.rows + 3 * kWidth);
      pull = part * lambda * load3<kWidth>(from.rows);
      if constexpr (!kToTip) here = plus(here, all(kFirstWeight), pull);
      store3<kWidth>(here, to.x);
    }
    for (int k = 0; k < last; ++k) {
      const bool is_last = k == last - 1;
      Vec3 next = load3<kWidth>(from.x += kPoint);
      if constexpr (kMove) {
        // Directions point against the sweep.
        Vec3 pull_next = zero3();
        if (!is_last) {
          const Lanes c_per_d = load(from.rows + 4 * kWidth);
          from.rows += kRow;
          lambda = hn::MulAdd(c_per_d, lambda, load(from.rows + 3 * kWidth));
          pull_next = part * lambda * load3<kWidth>(from.rows);
        }
        Vec3 move = pull_next - pull;
        if (is_last) move = all(kLastWeight) * move;
        next = next + move;
        pull = pull_next;
        store3<kWidth>(next, to.x += kPoint);
      }
      const Vec3 e = next - here;
      const Length length = length_of(e);
      Vec3 u = length.reciprocal * e;
      const Which none = length.value <= all(0);
      if (HWY_UNLIKELY(!hn::AllFalse(Tag(), none))) {
        const Vec3 tangent = kToTip ? tangent_ : zero3() - tangent_;
        u = choose(none, k == 0 ? tangent : load3<kWidth>(to.rows - kRow), u);
      }
      const Lanes wrong = rest_ - length.value, error = wrong * per_rest_;
      errors.largest = hn::Max(errors.largest, hn::Abs(error));
      errors.squared = hn::MulAdd(error, error, errors.squared);

      store3<kWidth>(u, to.rows);
      store(wrong, to.rows + 3 * kWidth);
      to.rows += kRow;
      here = next;
    }
    return errors;
  }

  template <bool kToTip>
  HWY_NOINLINE void eliminate_along(double* rows) const {
    const auto segment = [&](int k) { return rows + (kToTip ? k : last_ - 1 - k) * kSegmentRow * kWidth; };
    constexpr double kFirstWeight = kToTip ? 0 : 2, kLastWeight = kToTip ? 2 : 0;
    Vec3 before = zero3();
    Lanes P = all(1), P_before = all(0), G = all(kFirstWeight), y = all(0), per_d = all(0);
    for (int k = 0; k < last_; ++k) {
      double* const row = segment(k);
      const Vec3 u = load3<kWidth>(row);
      const Lanes c = dot(before, u), c_per_d = c * per_d;
      G = hn::MulAdd(hn::NegMulAdd(c, c, all(1)), P_before, G);
      const Lanes P_now = k == last_ - 1 ? hn::MulAdd(all(kLastWeight), P, G) : P + G;
      const Lanes per_P = reciprocal(P_now);
      per_d = P * per_P;
      P_before = P;
      P = P_now;
      if (k % kLongestProduct == kLongestProduct - 1) {
        G = G * per_P;
        P_before = P_before * per_P;
        P = P * per_P;
      }
      y = hn::MulAdd(c_per_d, y, load(row + 3 * kWidth));
      store(y * per_d, row + 3 * kWidth);
      store(c_per_d, row + 4 * kWidth);
      before = u;
    }
  }

  // A pivot is at most 3, so a product of so many does not overflow.
  static constexpr int kLongestProduct = 64;

  int last_;
  Lanes rest_, per_rest_;
  Vec3 tangent_;
};

// Corrects x, with `other` as memory. Returns the one of the two that holds the result.
HWY_NOINLINE double* correct_lengths(const StepConstants& step, const Group& group, std::size_t lane,
                                     double* rows, double* x, double* other) {
  const Lanes rest = load(group.rest_length + lane);
  const Vec3 root = load3<kWidth>(x);
  const Vec3 tangent = turned(step.after.turn, load3<kGroup>(group.tangent + lane));
  const LengthCorrection correction(group.points, rest, tangent);

  // H5's bound for what rounding allows, with |x_i| at most |root| + L once the lengths are right.
  const Lanes reach = hn::Max(hn::Abs(root.x), hn::Max(hn::Abs(root.y), hn::Abs(root.z)));
  const Lanes rounding = all(0x1p-51) * (reach / rest + all(group.points - 1));
  const Lanes goal = hn::Max(all(step.length_tolerance), rounding), infinite = hn::Inf(Tag());

  MeasuredStrands now{x, rows}, tried{other, rows + group.points * kSegmentRow * kWidth};
  bool to_tip = true;
  LengthErrors errors = correction.measure(to_tip, now);
  for (int steps = 1; steps <= kMostLengthSteps; ++steps) {
    const Which active = hn::And(errors.largest > goal, errors.squared < infinite);
    if (hn::AllFalse(Tag(), active)) return now.x;
    correction.eliminate(to_tip, now);
    to_tip = !to_tip;
    Lanes part = hn::IfThenElseZero(active, all(1));  // the others do not move
    const Lanes before = errors.squared;
    Which failed = hn::Not(active);
    for (;;) {
      errors = correction.attempt(to_tip, now, part, tried);
      failed = hn::AndNot(errors.squared < before, active);
      const Which halve = hn::And(failed, part > all(kSmallestPart));
      if (HWY_LIKELY(hn::AllFalse(Tag(), halve))) break;
      part = hn::IfThenElse(halve, all(0.5) * part, part);
    }
    if (HWY_UNLIKELY(steps > kMostNewtonSteps)) failed = active;
    if (HWY_UNLIKELY(!hn::AllFalse(Tag(), failed))) {
      correction.place(now.x, failed, tried.x);
      errors = correction.measure(to_tip, tried);
      errors.largest = hn::IfThenZeroElse(failed, errors.largest);  // done
    }
    std::swap(now, tried);
  }
  return now.x;
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
