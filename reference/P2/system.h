// STAFF ONLY. Particles under constraints with their known quantities as tables, for comparison with a
// student's answers.
//
// Bounds. u = 2^-53. A row of J has at most 6 entries; each is a difference of coordinates, rounded once. In
// any implementation a sum over them has a rounding error of at most 16 u times the sum of its terms' sizes,
// written |.|; so two implementations differ by at most 32 u.
#pragma once

#include <string>
#include <vector>

#include "grader/judge/cases/random.h"
#include "particles/constraint_forces.h"

namespace grader {

struct ConstrainedSystem {
  std::string name;
  particles::Constraints constraints;
  particles::Particles particles;
  particles::State state;
  Eigen::VectorXd f;  // the other forces

  int n() const { return particles.count(); }
  int rows() const { return constraints.rows(); }

  Eigen::MatrixXd jacobian() const;         // J, rows() x 3n
  Eigen::VectorXd inverse_masses() const;   // W's diagonal, 3n
  Eigen::MatrixXd matrix() const;           // J W J^T
  Eigen::VectorXd values() const;           // C
  Eigen::VectorXd curvature() const;        // J' v
  Eigen::VectorXd right_hand_side() const;  // -J' v - J W f - stiffness C - damping J v

  double matrix_size() const;           // the norm of |J| W |J|^T, at least that of the matrix
  double value_size() const;            // the size of the terms in C
  double right_hand_side_size() const;  // the size of the terms in the right-hand side

  // The largest allowed difference between ||right-hand side - J W J^T lambda|| and the value of a student's
  // ConjGrad: from the contract of solver/linearSolver.h, and from the rounding of the student's right-hand
  // side.
  double residual_rounding(const Eigen::VectorXd& lambda) const;
};

// n particles, about 1 apart and with masses from 0.1 to 10, in a chain of n - 1 rods. They move under other
// forces, and no rod has its length; there is no feedback.
ConstrainedSystem random_chain(Random& random, int n);

// Adds a wire for the particle i, which is not on it.
void add_wire(Random& random, ConstrainedSystem& system, int i);

// The system with the sizes of rods and wires changed such that C = 0.
ConstrainedSystem held(ConstrainedSystem system);

// The same system with all velocities 0.
ConstrainedSystem at_rest(ConstrainedSystem system);

// Chains of rods, long and short.
std::vector<ConstrainedSystem> chains(Random& random);

// Rods that share no particle, of lengths from 0.7 to 1.3, and equal masses, which are not 1. Each row of J W
// J' has one entry: a mistake in how constraints meet does not show, and one in W is a factor of the whole
// matrix.
ConstrainedSystem separate_rods(Random& random, int rods);

// Beads with no other constraints; the wires are not in the beads' order.
std::vector<ConstrainedSystem> beads(Random& random);

// Chains with a bead at either end.
std::vector<ConstrainedSystem> hung_chains(Random& random);

// n particles with rods between all pairs.
ConstrainedSystem rigid_body(Random& random, int n);

}  // namespace grader
