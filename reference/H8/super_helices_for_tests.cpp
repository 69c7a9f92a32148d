// STAFF ONLY. Makes super-helices of hair.
#include "reference/H8/super_helices_for_tests.h"

#include "hair/strand/material.h"

namespace reference_tests {

HelixStrand hair_strand(int elements, double length, const Vector3d& natural) {
  const hair::Material material;
  HelixStrand strand;
  strand.lengths = VectorXd::Constant(elements, length / elements);
  strand.line_density = material.line_density();
  strand.bend_rigidity = material.bend_rigidity();
  strand.twist_rigidity = material.twist_rigidity();
  strand.natural = natural.replicate(elements, 1);
  return strand;
}

VectorXd random_curl(const HelixStrand& strand, double angle, RandomNumbers& numbers) {
  VectorXd q(3 * strand.elements());
  for (int i = 0; i < strand.elements(); ++i)
    q.segment<3>(3 * i) = numbers.direction() * numbers.between(0, angle) / strand.lengths[i];
  return q;
}

HelixRoot random_root(RandomNumbers& numbers) {
  HelixRoot root;
  root.frame = {numbers.vector(0.1), numbers.turn().toRotationMatrix()};
  root.velocity = numbers.vector(1);
  root.spin = numbers.vector(10);
  root.acceleration = numbers.vector(10);
  root.spin_acceleration = numbers.vector(100);
  return root;
}

hair::MaterialFrame some_start() {
  RandomNumbers numbers(1);
  return {numbers.vector(1), numbers.turn().toRotationMatrix()};
}

VectorXd helix_step(const HelixMotion& motion, const VectorXd& q, const VectorXd& rates, double h) {
  MatrixXd scratch(q.size(), q.size() + 10);
  VectorXd change(q.size());
  hair::helix_step(motion.strand(), motion.elements, motion.points, q, rates, h, scratch, change);
  return change;
}

}  // namespace reference_tests
