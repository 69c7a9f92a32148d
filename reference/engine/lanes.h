// STAFF ONLY. Vectors and matrices of three, in each lane those of another strand. This header is compiled
// once for each instruction set (Highway's foreach_target.h).
#if defined(HAIR_REFERENCE_ENGINE_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_LANES_H_
#undef HAIR_REFERENCE_ENGINE_LANES_H_
#else
#define HAIR_REFERENCE_ENGINE_LANES_H_
#endif

#include <hwy/highway.h>

#include "reference/engine/group.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, kGroup>;
using Lanes = hn::Vec<Tag>;
using Which = hn::Mask<Tag>;

inline constexpr std::size_t kWidth = hn::MaxLanes(Tag());

HWY_INLINE Lanes all(double value) {
  return hn::Set(Tag(), value);
}
HWY_INLINE Lanes load(const double* from) {
  return hn::Load(Tag(), from);
}
HWY_INLINE void store(Lanes value, double* to) {
  hn::Store(value, Tag(), to);
}

// 1 / a and 1 / sqrt(a) of normal numbers a > 0. AVX-512 has r = 14 bits of them at once. With e = 1 - a r,
// or 1 - a r^2, which is less than 2^-13, the rest is a series whose terms from e^4 on are below rounding,
//
//   1 / a = r (1 + e) (1 + e^2),   1 / sqrt(a) = r (1 + e / 2 + 3 e^2 / 8 + 5 e^3 / 16),
//
// and takes a quarter of the time that the processor's unit needs for divisions and roots. Processors differ
// in the bits of r beyond these 14. Targets better than AVX3 have smaller numbers.
HWY_INLINE Lanes reciprocal(Lanes a) {
#if HWY_TARGET <= HWY_AVX3
  const Lanes r{_mm512_rcp14_pd(a.raw)}, e = hn::NegMulAdd(a, r, all(1)), closer = hn::MulAdd(r, e, r);
  return hn::MulAdd(closer, e * e, closer);
#else
  return all(1) / a;
#endif
}
HWY_INLINE Lanes reciprocal_root(Lanes a) {
#if HWY_TARGET <= HWY_AVX3
  const Lanes r{_mm512_rsqrt14_pd(a.raw)}, e = hn::NegMulAdd(a * r, r, all(1));
  return hn::MulAdd(r * e, hn::MulAdd(e, hn::MulAdd(e, all(0.3125), all(0.375)), all(0.5)), r);
#else
  return all(1) / hn::Sqrt(a);
#endif
}

template <class V>
struct Three {
  V x, y, z;
};
using Vec3 = Three<Lanes>;

// Loads numbers that are kStride doubles apart: kGroup in a group, kWidth in scratch memory.
template <std::size_t kStride>
HWY_INLINE Vec3 load3(const double* from) {
  return {load(from), load(from + kStride), load(from + 2 * kStride)};
}
template <std::size_t kStride>
HWY_INLINE void store3(const Vec3& a, double* to) {
  store(a.x, to);
  store(a.y, to + kStride);
  store(a.z, to + 2 * kStride);
}

HWY_INLINE Vec3 all3(const double* value) {
  return {all(value[0]), all(value[1]), all(value[2])};
}
HWY_INLINE Vec3 zero3() {
  return {all(0), all(0), all(0)};
}
template <class V>
HWY_INLINE Three<V> operator+(const Three<V>& a, const Three<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
HWY_INLINE Three<V> operator-(const Three<V>& a, const Three<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
HWY_INLINE Three<V> operator*(V s, const Three<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
// a + s b and a - s b.
template <class V>
HWY_INLINE Three<V> plus(const Three<V>& a, V s, const Three<V>& b) {
  return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}
template <class V>
HWY_INLINE Three<V> minus(const Three<V>& a, V s, const Three<V>& b) {
  return {hn::NegMulAdd(s, b.x, a.x), hn::NegMulAdd(s, b.y, a.y), hn::NegMulAdd(s, b.z, a.z)};
}
template <class V>
HWY_INLINE V dot(const Three<V>& a, const Three<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z));
}
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
  return {hn::MulSub(a.y, b.z, a.z * b.y), hn::MulSub(a.z, b.x, a.x * b.z), hn::MulSub(a.x, b.y, a.y * b.x)};
}
// The length of e and its reciprocal, which is a large number for a length of 0. Max's order lets NaN
// through.
struct Length {
  Lanes value, reciprocal;
};
HWY_INLINE Length length_of(const Vec3& e) {
  const Lanes squared = dot(e, e), per_length = reciprocal_root(hn::Max(all(1e-300), squared));
  return {squared * per_length, per_length};
}
template <class M, class V>
HWY_INLINE Three<V> choose(M which, const Three<V>& yes, const Three<V>& no) {
  return {hn::IfThenElse(which, yes.x, no.x), hn::IfThenElse(which, yes.y, no.y),
          hn::IfThenElse(which, yes.z, no.z)};
}

// The lower half of a symmetric matrix.
struct Sym3 {
  Lanes xx, yx, yy, zx, zy, zz;
};

HWY_INLINE Sym3 diagonal(Lanes d) {
  const Lanes zero = all(0);
  return {d, zero, d, zero, zero, d};
}
HWY_INLINE Sym3 square(const Vec3& a) {  // a a^T
  return {a.x * a.x, a.y * a.x, a.y * a.y, a.z * a.x, a.z * a.y, a.z * a.z};
}
HWY_INLINE Sym3 operator+(const Sym3& a, const Sym3& b) {
  return {a.xx + b.xx, a.yx + b.yx, a.yy + b.yy, a.zx + b.zx, a.zy + b.zy, a.zz + b.zz};
}
HWY_INLINE Sym3 operator*(Lanes s, const Sym3& a) {
  return {s * a.xx, s * a.yx, s * a.yy, s * a.zx, s * a.zy, s * a.zz};
}

// a + b c^T, where it is symmetric.
HWY_INLINE Sym3 plus(const Sym3& a, const Vec3& b, const Vec3& c) {
  return {hn::MulAdd(b.x, c.x, a.xx), hn::MulAdd(b.y, c.x, a.yx), hn::MulAdd(b.y, c.y, a.yy),
          hn::MulAdd(b.z, c.x, a.zx), hn::MulAdd(b.z, c.y, a.zy), hn::MulAdd(b.z, c.z, a.zz)};
}

struct Mat3 {
  Vec3 x, y, z;  // rows
};

HWY_INLINE Mat3 operator+(const Mat3& a, const Mat3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Mat3 operator-(const Mat3& a, const Mat3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Mat3 full(const Sym3& a) {
  return {{a.xx, a.yx, a.zx}, {a.yx, a.yy, a.zy}, {a.zx, a.zy, a.zz}};
}

HWY_INLINE Vec3 turned(const double (&turn)[3][3], const Vec3& a) {
  return {dot(all3(turn[0]), a), dot(all3(turn[1]), a), dot(all3(turn[2]), a)};
}
// A change of axes: a root's place on the head, for instance. Its numbers are already in all lanes, so that a
// loop need not spread them over and over.
struct Axes {
  Lanes turn[3][3], at[3];

  HWY_INLINE explicit Axes(const Pose& pose) {
    for (int row = 0; row < 3; ++row) {
      at[row] = all(pose.at[row]);
      for (int column = 0; column < 3; ++column) turn[row][column] = all(pose.turn[row][column]);
    }
  }
  HWY_INLINE Vec3 operator()(const Vec3& a) const {
    const auto along = [&](int row) {
      return hn::MulAdd(turn[row][0], a.x,
                        hn::MulAdd(turn[row][1], a.y, hn::MulAdd(turn[row][2], a.z, at[row])));
    };
    return {along(0), along(1), along(2)};
  }
};

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
