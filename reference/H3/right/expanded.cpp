// STAFF ONLY. A right solution of H3 with everything multiplied out. Its terms cancel where a strand is bent
// a little.

#include "hair/bend_springs.h"

#include <cmath>

using Eigen::Vector3d;
using hair::Strand;

namespace {

double rest(const Strand& strand, int i) {
  return strand.rest_length[i] + strand.rest_length[i + 1];
}

Vector3d between(particles::Input x, int i) {
  return x.segment<3>(3 * i + 6) - x.segment<3>(3 * i);
}

}  // namespace

double hair::bend_spring_energy(const Strand& strand, Input x) {
  double sum = 0;
  for (int i = strand.count() - 3; i >= 0; --i) {
    const Vector3d d = between(x, i);
    const double d0 = rest(strand, i);
    sum += (d.dot(d) - 2 * std::sqrt(d.dot(d)) * d0 + d0 * d0) / d0;
  }
  return strand.skip_rigidity / 2 * sum;
}

void hair::add_bend_spring_force(const Strand& strand, Input x, Output f) {
  for (int i = strand.count() - 3; i >= 0; --i) {
    const Vector3d d = between(x, i);
    const double distance = std::sqrt(d.dot(d));
    if (distance == 0) continue;
    const Vector3d pull = strand.skip_rigidity / rest(strand, i) * d - strand.skip_rigidity / distance * d;
    f.segment<3>(3 * i) += pull;
    f.segment<3>(3 * i + 6) -= pull;
  }
}

void hair::add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = strand.count() - 3; i >= 0; --i) {
    const Vector3d d = between(x, i), dd = between(dx, i);
    const double squared = d.dot(d), distance = std::sqrt(squared), d0 = rest(strand, i),
                 k = strand.skip_rigidity / d0;
    if (distance == 0) continue;
    const bool along_only =
        term == GeometricTerm::dropped || (term == GeometricTerm::filtered && distance < d0);
    const Vector3d pull =
        along_only
            ? Vector3d(k * d.dot(dd) / squared * d)
            : Vector3d(k * dd - k * d0 / distance * dd + k * d0 * d.dot(dd) / (squared * distance) * d);
    df.segment<3>(3 * i) += pull;
    df.segment<3>(3 * i + 6) -= pull;
  }
}
