// STAFF ONLY. A right solution of H3, formula by formula.

#include "hair/bend_springs.h"

#include <cmath>

using Eigen::Matrix3d;
using Eigen::Vector3d;

double hair::bend_spring_energy(const Strand& strand, Input x) {
  double E = 0;
  for (int i = 0; i + 2 < strand.count(); i++) {
    double d0 = strand.rest_length(i) + strand.rest_length(i + 1);
    double k = strand.skip_rigidity / d0;
    double d = (x.segment<3>(3 * (i + 2)) - x.segment<3>(3 * i)).norm();
    E += 0.5 * k * (d - d0) * (d - d0);
  }
  return E;
}

void hair::add_bend_spring_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i + 2 < strand.count(); i++) {
    double d0 = strand.rest_length(i) + strand.rest_length(i + 1);
    double k = strand.skip_rigidity / d0;
    Vector3d e = x.segment<3>(3 * (i + 2)) - x.segment<3>(3 * i);
    double d = e.norm();
    if (d == 0) continue;
    Vector3d force = k * (d - d0) / d * e;
    f.segment<3>(3 * i) += force;
    f.segment<3>(3 * (i + 2)) -= force;
  }
}

void hair::add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = 0; i + 2 < strand.count(); i++) {
    double d0 = strand.rest_length(i) + strand.rest_length(i + 1);
    double k = strand.skip_rigidity / d0;
    Vector3d e = x.segment<3>(3 * (i + 2)) - x.segment<3>(3 * i);
    double d = e.norm();
    if (d == 0) continue;
    Vector3d u = e / d;
    double g = 1 - d0 / d;
    if (term == GeometricTerm::filtered && g < 0) g = 0;
    if (term == GeometricTerm::dropped) g = 0;
    Matrix3d H = k * (u * u.transpose() + g * (Matrix3d::Identity() - u * u.transpose()));
    Vector3d change = H * (dx.segment<3>(3 * (i + 2)) - dx.segment<3>(3 * i));
    df.segment<3>(3 * i) += change;
    df.segment<3>(3 * (i + 2)) -= change;
  }
}
