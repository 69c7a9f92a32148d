#include "particles/springs.h"

#include <algorithm>
#include <utility>

#include "particles/require.h"

namespace particles {
namespace {

// The value of particle i minus that of particle j. Without `inline` GCC calls it, and cloth takes a third
// longer.
inline Vector3d between(const Spring& spring, Input values) {
  return values.segment<3>(3 * spring.i) - values.segment<3>(3 * spring.j);
}

void add_pair(const Spring& spring, const Vector3d& on_i, Output f) {
  f.segment<3>(3 * spring.i) += on_i;
  f.segment<3>(3 * spring.j) -= on_i;
}

}  // namespace

DampedSprings::DampedSprings(std::vector<Spring> springs, Products products)
    : springs_(std::move(springs)), products_(products) {
  for (const Spring& spring : springs_) {
    require(spring.i >= 0, "DampedSprings: i", spring.i, ">= 0");
    require(spring.j >= 0, "DampedSprings: j", spring.j, ">= 0");
    require(spring.i != spring.j, "DampedSprings: j", spring.j, "other than i");
    require(spring.stiffness >= 0, "DampedSprings: stiffness", spring.stiffness, ">= 0");
    require(spring.rest_length >= 0, "DampedSprings: rest length", spring.rest_length, ">= 0");
    require(spring.damping >= 0, "DampedSprings: damping", spring.damping, ">= 0");
  }
}

double DampedSprings::energy(Input x) const {
  double energy = 0;
  for (const Spring& spring : springs_) {
    const double stretch = between(spring, x).norm() - spring.rest_length;
    energy += 0.5 * spring.stiffness * stretch * stretch;
  }
  return energy;
}

void DampedSprings::add_force(Input x, Input v, Output f) const {
  for (const Spring& spring : springs_) {
    const Vector3d d = between(spring, x);
    const double length = d.norm();
    if (length == 0) continue;
    const Vector3d u = d / length;
    const double tension =
        spring.stiffness * (length - spring.rest_length) + spring.damping * between(spring, v).dot(u);
    add_pair(spring, -tension * u, f);
  }
}

void DampedSprings::add_dfdx(Input x, Input v, Input dx, Output df) const {
  for (const Spring& spring : springs_) {
    const Vector3d d = between(spring, x);
    const double length = d.norm();
    if (length == 0) continue;
    const Vector3d u = d / length, change = between(spring, dx);
    const double along = change.dot(u);
    const Vector3d across = change - along * u;  // u turns by across / length
    const double k = spring.stiffness, slack = 1 - spring.rest_length / length;
    if (products_ == Products::definite) {
      add_pair(spring, -k * along * u - k * std::max(slack, 0.0) * across, df);
    } else {
      const Vector3d w = between(spring, v), turn = across / length;
      const Vector3d damped = spring.damping * (w.dot(turn) * u + w.dot(u) * turn);
      add_pair(spring, -k * along * u - k * slack * across - damped, df);
    }
  }
}

void DampedSprings::add_dfdv(Input x, Input /*v*/, Input dv, Output df) const {
  for (const Spring& spring : springs_) {
    const Vector3d d = between(spring, x);
    const double squared = d.squaredNorm();
    if (squared == 0) continue;
    add_pair(spring, -spring.damping * between(spring, dv).dot(d) / squared * d, df);
  }
}

}  // namespace particles
