// STAFF ONLY. H1: stretch springs.

#include "hair/stretch_springs.h"

#include <algorithm>

namespace hair {
namespace {

using particles::Vector3d;

// Segment i of a strand at x.
struct Segment {
  Segment(const Strand& strand, Input x, int i)
      : first(3 * i),
        second(3 * i + 3),
        rest_length(strand.rest_length[i]),
        stiffness(strand.stretch_rigidity / rest_length) {
    const Vector3d e = x.segment<3>(second) - x.segment<3>(first);
    length = e.norm();
    if (length > 0) direction = e * (1 / length);
  }

  int first, second;  // its particles' numbers begin here
  double rest_length, stiffness, length;
  Vector3d direction = Vector3d::Zero();
};

// 1 - l0/l, or less of it, as `term` says.
double geometric(GeometricTerm term, const Segment& s) {
  if (term == GeometricTerm::dropped) return 0;
  const double share = 1 - s.rest_length / s.length;
  return term == GeometricTerm::filtered ? std::max(share, 0.0) : share;
}

}  // namespace

double stretch_energy(const Strand& strand, Input x) {
  double energy = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Segment s(strand, x, i);
    const double stretch = s.length - s.rest_length;
    energy += s.stiffness * stretch * stretch / 2;
  }
  return energy;
}

void add_stretch_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i < strand.segments(); ++i) {
    const Segment s(strand, x, i);
    const Vector3d pull = s.stiffness * (s.length - s.rest_length) * s.direction;
    f.segment<3>(s.first) += pull;
    f.segment<3>(s.second) -= pull;
  }
}

void add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = 0; i < strand.segments(); ++i) {
    const Segment s(strand, x, i);
    if (s.length == 0) continue;
    const Vector3d de = dx.segment<3>(s.second) - dx.segment<3>(s.first);
    const Vector3d along = s.direction * s.direction.dot(de);
    const Vector3d pull = s.stiffness * (along + geometric(term, s) * (de - along));
    df.segment<3>(s.first) += pull;
    df.segment<3>(s.second) -= pull;
  }
}

}  // namespace hair
