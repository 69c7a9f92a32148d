// STAFF ONLY. A right solution of H1 that writes down a length. Dual numbers make the derivatives.

#include "hair/stretch_springs.h"

#include <array>
#include <cmath>

namespace {

#include "dual.h"

template <class T>
T length(const Vec<T>& e) {
  return sqrt(dot(e, e));
}

struct Length {
  double l;
  Eigen::Vector3d gradient, turned;  // dl/de, d2l/de2 along a direction
};

Length length_of(const Eigen::Vector3d& e, const Eigen::Vector3d& de) {
  Length result;
  for (int j = 0; j < 3; j++) {
    Vec<D2> a;
    for (int i = 0; i < 3; i++) a[i] = D2(D1(e[i], i == j), D1(de[i], 0));
    D2 l = length(a);
    result.l = l.v.v;
    result.gradient[j] = l.v.d;
    result.turned[j] = l.d.d;
  }
  return result;
}

Eigen::Vector3d segment(particles::Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

}  // namespace

namespace hair {

double stretch_energy(const Strand& strand, Input x) {
  double E = 0;
  for (int i = 0; i < strand.segments(); i++) {
    double l0 = strand.rest_length[i], l = segment(x, i).norm();
    E += strand.stretch_rigidity / l0 * (l - l0) * (l - l0) / 2;
  }
  return E;
}

void add_stretch_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i < strand.segments(); i++) {
    Eigen::Vector3d e = segment(x, i);
    if (e.isZero(0)) continue;
    double l0 = strand.rest_length[i];
    Length l = length_of(e, Eigen::Vector3d::Zero());
    Eigen::Vector3d dE = strand.stretch_rigidity / l0 * (l.l - l0) * l.gradient;
    f.segment<3>(3 * i) += dE;
    f.segment<3>(3 * i + 3) -= dE;
  }
}

void add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = 0; i < strand.segments(); i++) {
    Eigen::Vector3d e = segment(x, i), de = segment(dx, i);
    if (e.isZero(0)) continue;
    double l0 = strand.rest_length[i];
    Length l = length_of(e, de);
    double pull = l.l - l0;
    if (term == GeometricTerm::dropped || (term == GeometricTerm::filtered && pull < 0)) pull = 0;
    Eigen::Vector3d d = strand.stretch_rigidity / l0 * (l.gradient * l.gradient.dot(de) + pull * l.turned);
    df.segment<3>(3 * i) += d;
    df.segment<3>(3 * i + 3) -= d;
  }
}

}  // namespace hair
