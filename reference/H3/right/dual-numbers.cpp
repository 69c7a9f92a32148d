// STAFF ONLY. A right solution of H3 that writes down a distance. Dual numbers make the derivatives.

#include "hair/bend_springs.h"

#include <array>
#include <cmath>

namespace {

#include "dual.h"

template <class T>
T distance(const Vec<T>& e) {
  return sqrt(dot(e, e));
}

struct Spring {
  double d0, k, d;
  Eigen::Vector3d gradient, turned;  // the distance's gradient, and its change along de
};

Spring spring_of(const hair::Strand& strand, int i, const Eigen::Vector3d& e, const Eigen::Vector3d& de) {
  Spring s;
  s.d0 = strand.rest_length[i] + strand.rest_length[i + 1];
  s.k = strand.skip_rigidity / s.d0;
  for (int j = 0; j < 3; j++) {
    Vec<D2> a;
    for (int m = 0; m < 3; m++) a[m] = D2(D1(e[m], m == j), D1(de[m], 0));
    D2 d = distance(a);
    s.d = d.v.v;
    s.gradient[j] = d.v.d;
    s.turned[j] = d.d.d;
  }
  return s;
}

Eigen::Vector3d between(particles::Input x, int i) {
  return x.segment<3>(3 * i + 6) - x.segment<3>(3 * i);
}

}  // namespace

namespace hair {

double bend_spring_energy(const Strand& strand, Input x) {
  double E = 0;
  for (int i = 2; i < strand.count(); i++) {
    double d0 = strand.rest_length[i - 2] + strand.rest_length[i - 1], d = between(x, i - 2).norm();
    E += strand.skip_rigidity / d0 * (d - d0) * (d - d0) / 2;
  }
  return E;
}

void add_bend_spring_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i < strand.count() - 2; i++) {
    Eigen::Vector3d e = between(x, i);
    if (e.isZero(0)) continue;
    Spring s = spring_of(strand, i, e, e);
    f.segment<3>(3 * i) += s.k * (s.d - s.d0) * s.gradient;
    f.segment<3>(3 * i + 6) -= s.k * (s.d - s.d0) * s.gradient;
  }
}

void add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = 0; i < strand.count() - 2; i++) {
    Eigen::Vector3d e = between(x, i), de = between(dx, i);
    if (e.isZero(0)) continue;
    Spring s = spring_of(strand, i, e, de);
    double pull = s.d - s.d0;
    if (term == GeometricTerm::dropped || (term == GeometricTerm::filtered && pull < 0)) pull = 0;
    Eigen::Vector3d change = s.k * (s.gradient * s.gradient.dot(de) + pull * s.turned);
    df.segment<3>(3 * i) += change;
    df.segment<3>(3 * i + 6) -= change;
  }
}

}  // namespace hair
