// STAFF ONLY. The factorisation A = L D L^T of a strand's matrix, a block column at a time, and the solve
// with it. Each column is eliminated as soon as it is complete. The active part of the matrix is a front of
// three points, which stays in registers. Source: I. S. Duff and J. K. Reid, "The Multifrontal Solution of
// Indefinite Sparse Symmetric Linear Equations" (ACM TOMS 9, 1983); for L D L^T: G. H. Golub and C. F. Van
// Loan, "Matrix Computations" (2013), section 4.1.2.
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
    // 1 / dy from the minor xx yy - yx^2, so that it does not wait for 1 / dx.
    const Lanes dx = a.xx, minor = hn::MulSub(a.xx, a.yy, a.yx * a.yx);
    const Lanes rx = reciprocal(dx), ry = dx * reciprocal(minor);
    yx = a.yx * rx;
    zx = a.zx * rx;
    const Lanes c = hn::NegMulAdd(zx, a.yx, a.zy);
    zy = c * ry;
    const Lanes dz = hn::NegMulAdd(zy, c, hn::NegMulAdd(zx, a.zx, a.zz));
    per_d = {rx, ry, reciprocal(dz)};
    definite = hn::And(definite, hn::Min(dx, hn::Min(minor, dz)) > all(0));
    rhs.x = b.x;
    rhs.y = hn::NegMulAdd(yx, b.x, b.y);
    rhs.z = hn::NegMulAdd(zy, rhs.y, hn::NegMulAdd(zx, b.x, b.z));
  }
};

// A block below a pivot: L D and L.
struct Below {
  Mat3 scaled, factor;

  HWY_INLINE Below(const Mat3& a, const Pivot& p) {
    scaled.x = a.x;
    scaled.y = minus(a.y, p.yx, a.x);
    scaled.z = minus(minus(a.z, p.zx, a.x), p.zy, scaled.y);
    factor = {p.per_d.x * scaled.x, p.per_d.y * scaled.y, p.per_d.z * scaled.z};
  }
};

// Subtracts an elimination's part from the blocks beyond it.
HWY_INLINE void take(const Below& b, Sym3& a) {
  const auto column = [&](const Vec3& l, const Vec3& c) {
    a.xx = hn::NegMulAdd(l.x, c.x, a.xx);
    a.yx = hn::NegMulAdd(l.y, c.x, a.yx);
    a.yy = hn::NegMulAdd(l.y, c.y, a.yy);
    a.zx = hn::NegMulAdd(l.z, c.x, a.zx);
    a.zy = hn::NegMulAdd(l.z, c.y, a.zy);
    a.zz = hn::NegMulAdd(l.z, c.z, a.zz);
  };
  column(b.factor.x, b.scaled.x);
  column(b.factor.y, b.scaled.y);
  column(b.factor.z, b.scaled.z);
}
// far near^T.
HWY_INLINE Mat3 product(const Below& far, const Below& near) {
  const auto column = [&](Lanes x, Lanes y, Lanes z) {
    return plus(plus(x * far.factor.x, y, far.factor.y), z, far.factor.z);
  };
  return {column(near.scaled.x.x, near.scaled.y.x, near.scaled.z.x),
          column(near.scaled.x.y, near.scaled.y.y, near.scaled.z.y),
          column(near.scaled.x.z, near.scaled.y.z, near.scaled.z.z)};
}
HWY_INLINE Vec3 product(const Below& b, const Pivot& p) {
  return plus(plus(p.rhs.x * b.factor.x, p.rhs.y, b.factor.y), p.rhs.z, b.factor.z);
}

// Rows of kFactorRow vectors: L's blocks of a column (the nearer one, the farther one), then the pivot.
// Right-hand sides are kept elsewhere.
HWY_INLINE void store33(const Mat3& a, double* to) {
  store3<kWidth>(a.x, to);
  store3<kWidth>(a.y, to + 3 * kWidth);
  store3<kWidth>(a.z, to + 6 * kWidth);
}
HWY_INLINE void store_pivot(const Pivot& p, double* row, double* rhs) {
  store3<kWidth>({p.yx, p.zx, p.zy}, row + 18 * kWidth);
  store3<kWidth>({p.rhs.x * p.per_d.x, p.rhs.y * p.per_d.y, p.rhs.z * p.per_d.z}, rhs);
}

// L^T y, for a block.
HWY_INLINE Vec3 transposed_product(const double* block, const Vec3& y) {
  return {dot(load3<kWidth>(block), y), dot(load3<kWidth>(block + 3 * kWidth), y),
          dot(load3<kWidth>(block + 6 * kWidth), y)};
}
// L^-T b, for a pivot.
HWY_INLINE Vec3 back(const double* row, const Vec3& b) {
  const Vec3 l = load3<kWidth>(row + 18 * kWidth);  // yx, zx, zy
  const Lanes y = hn::NegMulAdd(l.z, b.z, b.y);
  return {hn::NegMulAdd(l.x, y, hn::NegMulAdd(l.y, b.z, b.x)), y, b.z};
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
