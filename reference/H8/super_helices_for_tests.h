// STAFF ONLY. Super-helices of hair for tests.
#pragma once

#include "hair/strand/material.h"
#include "hair/super_helix/helix_forces.h"
#include "reference/H7/link_trees_for_tests.h"

namespace reference_tests {

using hair::HelixMotion, hair::HelixRoot, hair::HelixStrand;

// Human hair of equal elements, with the same natural curvatures in each.
inline HelixStrand hair_strand(int elements, double length, const Vector3d& natural = Vector3d::Zero()) {
  const hair::Material material;
  HelixStrand strand;
  strand.lengths = VectorXd::Constant(elements, length / elements);
  strand.line_density = material.line_density();
  strand.bend_rigidity = material.bend_rigidity();
  strand.twist_rigidity = material.twist_rigidity();
  strand.natural = natural.replicate(elements, 1);
  return strand;
}

// Coordinates of a curl that winds by up to `angle` in each element.
inline VectorXd random_curl(const HelixStrand& strand, double angle, RandomNumbers& numbers) {
  VectorXd q(3 * strand.elements());
  for (int i = 0; i < strand.elements(); ++i)
    q.segment<3>(3 * i) = numbers.direction() * numbers.between(0, angle) / strand.lengths[i];
  return q;
}

inline HelixRoot random_root(RandomNumbers& numbers) {
  HelixRoot root;
  root.frame = {numbers.vector(0.1), numbers.turn().toRotationMatrix()};
  root.velocity = numbers.vector(1);
  root.spin = numbers.vector(10);
  root.acceleration = numbers.vector(10);
  root.spin_acceleration = numbers.vector(100);
  return root;
}

}  // namespace reference_tests
