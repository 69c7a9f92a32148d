// STAFF ONLY. A right solution of H1 with everything multiplied out: squares of differences, and the vector
// k e instead of k l u. Its terms cancel near the rest length.

#include "hair/stretch_springs.h"

#include <cmath>

using Eigen::Vector3d;

namespace {

Vector3d segment(particles::Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

}  // namespace

double hair::stretch_energy(const Strand& strand, Input x) {
  double sum = 0;
  for (int i = strand.segments() - 1; i >= 0; --i) {
    const Vector3d e = segment(x, i);
    const double l0 = strand.rest_length[i];
    sum += (e.dot(e) - 2 * std::sqrt(e.dot(e)) * l0 + l0 * l0) / l0;
  }
  return strand.stretch_rigidity / 2 * sum;
}

void hair::add_stretch_force(const Strand& strand, Input x, Output f) {
  for (int i = strand.segments() - 1; i >= 0; --i) {
    const Vector3d e = segment(x, i);
    const double l = std::sqrt(e.dot(e)), k = strand.stretch_rigidity / strand.rest_length[i];
    if (l == 0) continue;
    const Vector3d pull = k * e - strand.stretch_rigidity / l * e;
    f.segment<3>(3 * i) += pull;
    f.segment<3>(3 * i + 3) -= pull;
  }
}

void hair::add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = strand.segments() - 1; i >= 0; --i) {
    const Vector3d e = segment(x, i), de = segment(dx, i);
    const double ee = e.dot(e), l = std::sqrt(ee), l0 = strand.rest_length[i],
                 k = strand.stretch_rigidity / l0;
    if (l == 0) continue;
    const bool along_only = term == GeometricTerm::dropped || (term == GeometricTerm::filtered && l < l0);
    const Vector3d pull = along_only ? Vector3d(k * e.dot(de) / ee * e)
                                     : Vector3d(k * de - k * l0 / l * de + k * l0 * e.dot(de) / (ee * l) * e);
    df.segment<3>(3 * i) += pull;
    df.segment<3>(3 * i + 3) -= pull;
  }
}
