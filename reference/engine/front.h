// STAFF ONLY. The factorisation A = L D L^T of a strand's matrix, a block column at a time, and the solve
// with it. Each column is eliminated as soon as it is complete. The active part of the matrix is a front of
// three points, which stays in the nearest cache. Source: I. S. Duff and J. K. Reid, "The Multifrontal
// Solution of Indefinite Sparse Symmetric Linear Equations" (ACM TOMS 9, 1983); for L D L^T: G. H. Golub and
// C. F. Van Loan, "Matrix Computations" (2013), section 4.1.2.
#if defined(HAIR_REFERENCE_ENGINE_FRONT_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_REFERENCE_ENGINE_FRONT_H_
#undef HAIR_REFERENCE_ENGINE_FRONT_H_
#else
#define HAIR_REFERENCE_ENGINE_FRONT_H_
#endif

#include "reference/engine/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

// A column's own block: its factor, the reciprocals of D, and the right-hand side after it.
struct Pivot {
  Lanes yx, zx, zy;  // below the diagonal of L
  Vec3 per_d, rhs;

  HWY_INLINE Pivot(const Sym3& a, const Vec3& b, Which& definite) {
    // With minors, D = xx, minor / xx, last / (xx minor): no division waits for another.
    const Lanes minor = hn::MulSub(a.xx, a.yy, a.yx * a.yx), minor_zy = hn::MulSub(a.xx, a.zy, a.zx * a.yx),
                minor_zz = hn::MulSub(a.xx, a.zz, a.zx * a.zx);
    const Lanes last = hn::MulSub(minor, minor_zz, minor_zy * minor_zy);
    const Lanes rx = reciprocal(a.xx), ry = a.xx * reciprocal(minor);
    per_d = {rx, ry, a.xx * minor * reciprocal(last)};
    yx = a.yx * rx;
    zx = a.zx * rx;
    zy = minor_zy * rx * ry;
    definite = hn::And(definite, hn::Min(a.xx, hn::Min(minor, last)) > all(0));
    rhs.x = b.x;
    rhs.y = hn::NegMulAdd(yx, b.x, b.y);
    rhs.z = hn::NegMulAdd(zy, rhs.y, hn::NegMulAdd(zx, b.x, b.z));
  }
};

// a - b . c and a + b . c; z is known last.
HWY_INLINE Lanes less(Lanes a, const Vec3& b, const Vec3& c) {
  return hn::NegMulAdd(b.z, c.z, hn::NegMulAdd(b.y, c.y, hn::NegMulAdd(b.x, c.x, a)));
}
HWY_INLINE Lanes more(Lanes a, const Vec3& b, const Vec3& c) {
  return hn::MulAdd(b.z, c.z, hn::MulAdd(b.y, c.y, hn::MulAdd(b.x, c.x, a)));
}

HWY_INLINE Mat3 load33(const double* from) {
  return {load3<kWidth>(from), load3<kWidth>(from + 3 * kWidth), load3<kWidth>(from + 6 * kWidth)};
}
HWY_INLINE void store33(const Mat3& a, double* to) {
  store3<kWidth>(a.x, to);
  store3<kWidth>(a.y, to + 3 * kWidth);
  store3<kWidth>(a.z, to + 6 * kWidth);
}

// Rows of kFactorRow vectors: L's blocks of a column, by rows and with the opposite sign (the nearer one, the
// farther one), then the pivot. Right-hand sides are kept elsewhere. Before its elimination a row has the
// matrix's blocks at these places, its own one in the pivot's.
enum FactorRow : std::size_t { kNear = 0, kFar = 9, kOwn = 18 };

HWY_INLINE void store_pivot(const Pivot& p, double* row, double* rhs) {
  store3<kWidth>({p.yx, p.zx, p.zy}, row + kOwn * kWidth);
  store3<kWidth>({p.rhs.x * p.per_d.x, p.rhs.y * p.per_d.y, p.rhs.z * p.per_d.z}, rhs);
}

// Eliminates with a block below a pivot, whose rows come with the opposite sign: stores L, and leaves L D in
// `scaled`. After each row it calls `take` with its number and L, so that few numbers are needed at a time.
template <class Block, class Take>
HWY_INLINE void eliminate(const Pivot& p, const Block& block, Vec3 (&scaled)[3], double* factor,
                          const Take& take) {
  for (int k = 0; k < 3; ++k) {
    Vec3& a = scaled[k] = block(k);
    a.y = hn::NegMulAdd(p.yx, a.x, a.y);
    a.z = hn::NegMulAdd(p.zy, a.y, hn::NegMulAdd(p.zx, a.x, a.z));
    const Vec3 l{p.per_d.x * a.x, p.per_d.y * a.y, p.per_d.z * a.z};
    store3<kWidth>(l, factor + 3 * k * kWidth);
    take(k, l);
  }
}

// y - L^T b, for a block that is stored with the opposite sign; b.x is known last.
HWY_INLINE Vec3 less_transposed(const Vec3& y, const double* block, const Vec3& b) {
  const Mat3 l = load33(block);
  return plus(plus(plus(y, b.z, l.z), b.y, l.y), b.x, l.x);
}
// L^-T b, for a pivot.
HWY_INLINE Vec3 back(const double* row, const Vec3& b) {
  const Vec3 l = load3<kWidth>(row + kOwn * kWidth);  // yx, zx, zy
  const Lanes y = hn::NegMulAdd(l.z, b.z, b.y);
  return {hn::NegMulAdd(l.x, y, hn::NegMulAdd(l.y, b.z, b.x)), y, b.z};
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
