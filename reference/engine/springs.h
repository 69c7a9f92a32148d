// STAFF ONLY. A strand's segments and joints, with their forces and their derivatives by the segments'
// vectors e.
//
// Stretch (H1), with S = k (g 1 + (1 - g) u u^T), g = max(1 - l0/l, 0).
//
// Bending (H2), with c = u1 x u2, cos = u1 . u2, and three functions of the angle that are smooth at phi = 0:
//
//   q = phi / sin,   s = (1 - max(phi cot phi, 0)) / sin^2,   r = 1 / (1 + cos),
//
//   dE/de1 = k q (cos u1 - u2) / l1,   dE/de2 = k q (cos u2 - u1) / l2.
//
// H2's definite product is k (t1 t1^T + p b b^T) / l1^2 and so on, with t = b x u and p = max(phi cot phi,
// 0). Since b = c / sin is undefined at phi = 0, it is written without b: t1 t1^T + b b^T = 1 - u1 u1^T, and
// t2 t1^T + b b^T = R - u2 u1^T with the rotation R = cos 1 + [c]x + r c c^T that takes u1 to u2. So
//
//   11: k (1 - u1 u1^T - s c c^T) / l1^2       21: -k (cos 1 + [c]x + (r - s) c c^T - u2 u1^T) / (l1 l2).
//
// With T = tan(phi/2), z = T^2 and atan(T) = T (1 + z P(z)), acute angles have q = 2 r (1 + z P), s = r^2 (1
// - P (1 - z)). P is a polynomial, interpolated at Chebyshev's points of 0 <= z <= 1: its error is 2.3e-16.
#if defined(HAIR_REFERENCE_ENGINE_SPRINGS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_SPRINGS_H_
#undef HAIR_REFERENCE_ENGINE_SPRINGS_H_
#else
#define HAIR_REFERENCE_ENGINE_SPRINGS_H_
#endif

#include <numbers>

#include "reference/engine/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

struct Segment {
  Vec3 u;
  Lanes length, per_length;
};

// A segment of length 0 has no direction.
HWY_INLINE Segment segment_along(const Vec3& e) {
  const Length length = length_of(e);
  return {length.reciprocal * e, length.value, length.reciprocal};
}

// The factor of s S / k across the segment, where S / k = g 1 + (1 - g) u u^T. Along the segment it is s.
HWY_INLINE Lanes stretch_across(const Segment& segment, Lanes rest_length, Lanes s) {
  return s * hn::Max(hn::NegMulAdd(rest_length, segment.per_length, all(1)), all(0));
}

// The numbers of a segment, from its row on: its direction and 1 / l, the stretch's h f / m, and h^2 / m
// times S across the segment. Then those of the joint with the segment before, without the lengths: c, and k,
// k s, k (s - r), k cos, h k q.
enum SegmentRow : std::size_t {
  kU = 0,
  kPerLength = 3,
  kTension,
  kAcross,
  kC,
  kK = kC + 3,
  kS,
  kSR,
  kCos,
  kQ,
  kSegmentNumbers
};

HWY_INLINE Lanes polynomial(Lanes z) {
  static constexpr double kP[] = {
      -0.33333333333333315,   0.1999999999998641,     -0.14285714284072867,   0.11111111032045885,
      -0.0909090706749639,    0.07692275905014771,    -0.06666332509211019,   0.05879865489802981,
      -0.05249518584337663,   0.04705209153071265,    -0.04165211802350559,   0.03536066107263382,
      -0.027590832895856107,  0.01880522404364234,    -0.01059534604369583,   0.004642163938026353,
      -0.0014627303082646208, 0.00029221739308086863, -2.7633793313601145e-05};
  // Even and odd powers are summed apart, which makes the chain half as long.
  const Lanes square = z * z;
  Lanes even = all(kP[18]), odd = all(kP[17]);
  for (int k = 16; k > 0; k -= 2) {
    even = hn::MulAdd(even, square, all(kP[k]));
    odd = hn::MulAdd(odd, square, all(kP[k - 1]));
  }
  return hn::MulAdd(odd, z, hn::MulAdd(even, square, all(kP[0])));
}

struct Angle {
  Lanes q, s, r;
};

HWY_INLINE Angle angle_of(Lanes cosine, Lanes sine_squared) {
  const Lanes one = all(1), larger = one + hn::Abs(cosine), r = reciprocal(larger);
  const Lanes z = sine_squared * r * r, P = polynomial(z);
  Angle angle{(r + r) * hn::MulAdd(z, P, one), r * r * hn::NegMulAdd(P, one - z, one), r};
  const Which obtuse = cosine < all(0);
  if (HWY_UNLIKELY(!hn::AllFalse(Tag(), obtuse))) {  // pi - phi is acute, and its cotangent is less than 0
    const Lanes per_square = one / hn::Max(all(1e-290), sine_squared);
    const Lanes q = hn::MulSub(all(std::numbers::pi), hn::Sqrt(per_square), angle.q);
    angle.q = hn::IfThenElse(obtuse, q, angle.q);
    angle.s = hn::IfThenElse(obtuse, per_square, angle.s);
    angle.r = hn::IfThenElse(obtuse, larger * per_square, angle.r);
  }
  return angle;
}

// Stores the joint of one and two: the numbers from c to the row's end.
HWY_INLINE void store_joint(const Vec3& one, const Vec3& two, Lanes k, Lanes h, double* row) {
  const Vec3 c = cross(one, two);
  const Lanes cosine = dot(one, two), sine_squared = dot(c, c);
  // A joint that is folded, or has no direction, has neither force nor product.
  const Which rigid = hn::And(sine_squared == all(0), cosine <= all(0));
  k = hn::IfThenZeroElse(rigid, k);
  const Angle angle = angle_of(cosine, sine_squared);
  store3<kWidth>(c, row + kC * kWidth);
  store(k, row + kK * kWidth);
  store(k * angle.s, row + kS * kWidth);
  store(k * (angle.s - angle.r), row + kSR * kWidth);
  store(k * cosine, row + kCos * kWidth);
  store(h * k * angle.q, row + kQ * kWidth);
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
