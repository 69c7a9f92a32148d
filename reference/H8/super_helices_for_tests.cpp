// STAFF ONLY. Makes super-helices of hair.
#include "reference/H8/super_helices_for_tests.h"

#include "hair/strand/material.h"
#include "solver/symmetric_eigen.h"

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

namespace {

VectorXd unbalanced(HelixMotion& motion, const hair::MaterialFrame& root, const Vector3d& gravity,
                    const VectorXd& q) {
  VectorXd elastic(q.size()), weight(q.size());
  motion.place(root, q);
  hair::add_weight(gravity, motion);
  hair::generalised_force(motion.elements, motion.points, weight);
  hair::elastic_force(motion.strand(), q, elastic);
  return weight + elastic;
}

}  // namespace

// Newton's method with a matrix by central differences. The matrix of an energy is symmetric; if it is not
// definite, the step adds enough to it to go down the energy. No element turns by more than half a radian at
// once.
VectorXd balanced(HelixMotion& motion, const hair::MaterialFrame& root, const Vector3d& gravity, VectorXd q) {
  const double length = motion.strand().lengths.sum(), small = 1e-5 / length;
  const long n = q.size();
  VectorXd K(n);
  hair::helix_stiffness(motion.strand(), K);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const VectorXd force = unbalanced(motion, root, gravity, q);
    MatrixXd matrix(n, n);
    for (long k = 0; k < n; ++k) {
      VectorXd ahead = q, behind = q;
      ahead[k] += small;
      behind[k] -= small;
      matrix.col(k) = (unbalanced(motion, root, gravity, behind) - unbalanced(motion, root, gravity, ahead)) /
                      (2 * small);
    }
    matrix = (matrix + matrix.transpose()).eval() / 2;
    const solver::SymmetricEigen modes = solver::symmetric_eigen(matrix);
    const VectorXd sizes = modes.values.cwiseAbs().cwiseMax(1e-6 * K.maxCoeff());
    VectorXd step = modes.vectors * sizes.cwiseInverse().asDiagonal() * modes.vectors.transpose() * force;
    double widest = 0;
    for (int i = 0; i < motion.strand().elements(); ++i)
      widest = std::max(widest, step.segment<3>(3 * i).norm() * motion.strand().lengths[i]);
    if (widest > 0.5) step *= 0.5 / widest;
    q += step;
    if (widest < 1e-12) break;
  }
  return q;
}

}  // namespace reference_tests
