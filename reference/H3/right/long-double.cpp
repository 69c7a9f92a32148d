// STAFF ONLY. A right H3 in long double: one function goes through the springs, with the sweep from the tip to the root.
#include "hair/bend_springs.h"

namespace hair {
namespace {

using Real = long double;
using Long3 = Eigen::Matrix<Real, 3, 1>;

Long3 across(Input x, int i) {
  return x.segment<3>(3 * i + 6).cast<Real>() - x.segment<3>(3 * i).cast<Real>();
}

// Calls spring(i, rest length, stiffness).
template <typename Spring>
void each_spring(const Strand& strand, const Spring& spring) {
  for (int i = strand.count() - 3; i >= 0; --i) {
    const Real rest = Real{strand.rest_length[i]} + Real{strand.rest_length[i + 1]};
    spring(i, rest, strand.skip_rigidity / rest);
  }
}

void add(int i, const Long3& force, Output f) {
  f.segment<3>(3 * i) += force.cast<double>();
  f.segment<3>(3 * i + 6) -= force.cast<double>();
}

}  // namespace

double bend_spring_energy(const Strand& strand, Input x) {
  Real twice = 0;
  each_spring(strand, [&](int i, Real rest, Real k) {
    const Real longer = across(x, i).norm() - rest;
    twice += k * longer * longer;
  });
  return static_cast<double>(twice / 2);
}

void add_bend_spring_force(const Strand& strand, Input x, Output f) {
  each_spring(strand, [&](int i, Real rest, Real k) {
    const Long3 e = across(x, i);
    if (e.norm() != 0) add(i, k * (e - rest * e.normalized()), f);
  });
}

void add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  each_spring(strand, [&](int i, Real rest, Real k) {
    const Long3 e = across(x, i), de = across(dx, i);
    const Real d = e.norm();
    if (d == 0) return;
    const Long3 u = e / d;
    Real turning = term == GeometricTerm::dropped ? 0 : (d - rest) / d;
    if (term == GeometricTerm::filtered && turning < 0) turning = 0;
    add(i, k * (turning * de + (1 - turning) * u.dot(de) * u), df);
  });
}

}  // namespace hair
