// STAFF ONLY. H3: springs that skip a particle.

#include "hair/bend_springs.h"

#include <algorithm>

namespace hair {
namespace {

using particles::Vector3d;

// The spring from particle i to particle i + 2.
struct Spring {
  Spring(const Strand& strand, Input x, int i)
      : from(3 * i),
        to(3 * i + 6),
        rest(strand.rest_length[i] + strand.rest_length[i + 1]),
        k(strand.skip_rigidity / rest) {
    const Vector3d between = x.segment<3>(to) - x.segment<3>(from);
    distance = between.norm();
    if (distance > 0) u = between / distance;
  }

  int from, to;  // its particles' numbers begin here
  double rest, k, distance;
  Vector3d u = Vector3d::Zero();
};

int springs(const Strand& strand) {
  return std::max(strand.count() - 2, 0);
}

}  // namespace

double bend_spring_energy(const Strand& strand, Input x) {
  double energy = 0;
  for (int i = 0; i < springs(strand); ++i) {
    const Spring spring(strand, x, i);
    const double change = spring.distance - spring.rest;
    energy += spring.k * change * change / 2;
  }
  return energy;
}

void add_bend_spring_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i < springs(strand); ++i) {
    const Spring spring(strand, x, i);
    const Vector3d tension = spring.k * (spring.distance - spring.rest) * spring.u;
    f.segment<3>(spring.from) += tension;
    f.segment<3>(spring.to) -= tension;
  }
}

void add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = 0; i < springs(strand); ++i) {
    const Spring spring(strand, x, i);
    if (spring.distance == 0) continue;
    double turn = term == GeometricTerm::dropped ? 0 : 1 - spring.rest / spring.distance;
    if (term == GeometricTerm::filtered) turn = std::max(turn, 0.0);
    const Vector3d apart = dx.segment<3>(spring.to) - dx.segment<3>(spring.from);
    const Vector3d along = spring.u.dot(apart) * spring.u;
    const Vector3d change = spring.k * (along + turn * (apart - along));
    df.segment<3>(spring.from) += change;
    df.segment<3>(spring.to) -= change;
  }
}

}  // namespace hair
