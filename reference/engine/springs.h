// STAFF ONLY. A strand's segments and joints, with their forces and their derivatives by the segments' vectors e.
//
// Stretch (H1), with S = k (g 1 + (1 - g) u u^T), g = max(1 - l0/l, 0).
//
// Bending (H2), with c = u1 x u2, cos = u1 . u2, and three functions of the angle that are smooth at phi = 0:
//
//   q = phi / sin,   s = (1 - max(phi cot phi, 0)) / sin^2,   r = 1 / (1 + cos),
//
//   dE/de1 = k q (cos u1 - u2) / l1,   dE/de2 = k q (cos u2 - u1) / l2.
//
// H2's definite product is k (t1 t1^T + p b b^T) / l1^2 and so on, with t = b x u and p = max(phi cot phi, 0). Since
// b = c / sin is undefined at phi = 0, it is written without b: t1 t1^T + b b^T = 1 - u1 u1^T, and t2 t1^T + b b^T = R - u2 u1^T
// with the rotation R = cos 1 + [c]x + r c c^T that takes u1 to u2. So
//
//   11: k (1 - u1 u1^T - s c c^T) / l1^2       21: -k (cos 1 + [c]x + (r - s) c c^T - u2 u1^T) / (l1 l2).
//
// With T = tan(phi/2), z = T^2 and atan(T) = T (1 + z P(z)), acute angles have q = 2 r (1 + z P), s = r^2 (1 - P (1 - z)). P is
// a polynomial, interpolated at Chebyshev's points of 0 <= z <= 1: its error is 2.3e-16.
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
  Sym3 uu;
};

// The clamp's direction: a segment without an end.
HWY_INLINE Segment endless(const Vec3& u) {
  return {u, all(0), all(0), square(u)};
}

// A segment of length 0 has no direction.
HWY_INLINE Segment segment_along(const Vec3& e) {
  const Length length = length_of(e);
  const Vec3 u = length.reciprocal * e;
  return {u, length.value, length.reciprocal, square(u)};
}

// s S / k = across 1 + along u u^T.
struct Stretch {
  Lanes across, along;

  HWY_INLINE Stretch(const Segment& segment, Lanes rest_length, Lanes s)
      : across(s * hn::Max(hn::NegMulAdd(rest_length, segment.per_length, all(1)), all(0))),
        along(s - across) {}
};

HWY_INLINE Lanes polynomial(Lanes z) {
  static constexpr double kP[] = {
      -0.33333333333333315,   0.1999999999998641,     -0.14285714284072867,   0.11111111032045885,
      -0.0909090706749639,    0.07692275905014771,    -0.06666332509211019,   0.05879865489802981,
      -0.05249518584337663,   0.04705209153071265,    -0.04165211802350559,   0.03536066107263382,
      -0.027590832895856107,  0.01880522404364234,    -0.01059534604369583,   0.004642163938026353,
      -0.0014627303082646208, 0.00029221739308086863, -2.7633793313601145e-05};
  // Even and odd powers apart: half as long a chain.
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

struct Joint {
  Vec3 turn1, turn2;  // dE/de1 = pull1 turn1, dE/de2 = pull2 turn2, times `force`
  Lanes pull1, pull2;
  Sym3 block11, block22;  // block22 with the stretch of the second segment
  Mat3 block21;

  // k scales the blocks, and k `force` the forces.
  HWY_INLINE Joint(const Segment& one, const Segment& two, Lanes k, Lanes force, const Stretch& stretch) {
    const Vec3 c = cross(one.u, two.u);
    const Lanes cosine = dot(one.u, two.u), sine_squared = dot(c, c);
    // Folded, or without a direction: neither force nor product.
    const Which rigid = hn::And(sine_squared == all(0), cosine <= all(0));
    k = hn::IfThenZeroElse(rigid, k);
    const Angle angle = angle_of(cosine, sine_squared);

    const Lanes pull = k * force * angle.q;
    pull1 = pull * one.per_length;
    pull2 = pull * two.per_length;
    turn1 = {hn::MulSub(cosine, one.u.x, two.u.x), hn::MulSub(cosine, one.u.y, two.u.y),
             hn::MulSub(cosine, one.u.z, two.u.z)};
    turn2 = {hn::MulSub(cosine, two.u.x, one.u.x), hn::MulSub(cosine, two.u.y, one.u.y),
             hn::MulSub(cosine, two.u.z, one.u.z)};

    const Sym3 cc = square(c);
    const Lanes k1 = k * one.per_length, k11 = k1 * one.per_length, k21 = k1 * two.per_length,
                k22 = k * two.per_length * two.per_length;
    block11 = minus(minus(diagonal(k11), k11, one.uu), k11 * angle.s, cc);
    block22 = minus(minus(diagonal(k22 + stretch.across), k22 - stretch.along, two.uu), k22 * angle.s, cc);

    const Lanes t = k21 * (angle.s - angle.r), straight = k21 * cosine;
    const Vec3 kc = k21 * c, ku = k21 * two.u;
    const Sym3 tcc = t * cc;
    // Columns of -(cos 1 + [c]x) k21 + t c c^T + k21 u2 u1^T.
    block21.x = plus({tcc.xx - straight, tcc.yx - kc.z, tcc.zx + kc.y}, one.u.x, ku);
    block21.y = plus({tcc.yx + kc.z, tcc.yy - straight, tcc.zy - kc.x}, one.u.y, ku);
    block21.z = plus({tcc.zx - kc.y, tcc.zy + kc.x, tcc.zz - straight}, one.u.z, ku);
  }
};

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
