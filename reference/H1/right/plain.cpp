// STAFF ONLY. A right solution of H1, formula by formula.

#include "hair/stretch_springs.h"

#include <cmath>

using Eigen::Matrix3d;
using Eigen::Vector3d;

double hair::stretch_energy(const Strand& strand, Input x) {
  double E = 0;
  for (int i = 0; i < strand.segments(); i++) {
    double l0 = strand.rest_length(i);
    double k = strand.stretch_rigidity / l0;
    Vector3d d = x.segment<3>(3 * (i + 1)) - x.segment<3>(3 * i);
    double l = d.norm();
    E += 0.5 * k * (l - l0) * (l - l0);
  }
  return E;
}

void hair::add_stretch_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i < strand.segments(); i++) {
    double l0 = strand.rest_length(i);
    double k = strand.stretch_rigidity / l0;
    Vector3d d = x.segment<3>(3 * (i + 1)) - x.segment<3>(3 * i);
    double l = d.norm();
    if (l == 0) continue;
    Vector3d u = d / l;
    Vector3d force = k * (l - l0) * u;
    f.segment<3>(3 * i) += force;
    f.segment<3>(3 * (i + 1)) -= force;
  }
}

void hair::add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = 0; i < strand.segments(); i++) {
    double l0 = strand.rest_length(i);
    double k = strand.stretch_rigidity / l0;
    Vector3d d = x.segment<3>(3 * (i + 1)) - x.segment<3>(3 * i);
    double l = d.norm();
    if (l == 0) continue;
    Vector3d u = d / l;
    Matrix3d uu = u * u.transpose();
    double g = 1 - l0 / l;
    if (term == GeometricTerm::filtered && g < 0) g = 0;
    if (term == GeometricTerm::dropped) g = 0;
    Matrix3d H = k * uu + k * g * (Matrix3d::Identity() - uu);
    Vector3d dxi = dx.segment<3>(3 * i);
    Vector3d dxj = dx.segment<3>(3 * (i + 1));
    df.segment<3>(3 * i) += H * (dxj - dxi);
    df.segment<3>(3 * (i + 1)) += H * (dxi - dxj);
  }
}
