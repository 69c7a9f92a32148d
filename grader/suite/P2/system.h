// STAFF ONLY. Particles under constraints with all that is known of them, by tables: what P2's suite compares
// a student's answers with.
//
// Bounds. u = 2^-53. A row of J has at most 6 entries; each is a difference of coordinates, rounded once, and
// a sum over them rounds by at most 16 u of the sum of its terms' sizes, written |.|, whoever computes it: 32
// u between two.
#pragma once

#include <string>
#include <vector>

#include "grader/suite/random.h"
#include "particles/constraint_forces.h"

namespace grader {

struct ConstrainedSystem {
  std::string name;
  particles::Constraints constraints;
  particles::Particles particles;
  particles::State state;
  Eigen::VectorXd f;  // other force

  int n() const { return particles.count(); }
  int rows() const { return constraints.rows(); }

  Eigen::MatrixXd jacobian() const;         // J, rows() x 3n
  Eigen::VectorXd inverse_masses() const;   // W's diagonal, 3n
  Eigen::MatrixXd matrix() const;           // J W J^T
  Eigen::VectorXd values() const;           // C
  Eigen::VectorXd curvature() const;        // J' v
  Eigen::VectorXd right_hand_side() const;  // -J' v - J W f - stiffness C - damping J v

  double matrix_size() const;           // the norm of |J| W |J|^T, >= that of the matrix
  double value_size() const;            // of the terms that C adds up
  double right_hand_side_size() const;  // of the terms that the right-hand side adds up

  // How far ||right-hand side - J W J^T lambda|| may be from what a student's ConjGrad returned, by the
  // contract of solver/linearSolver.h, and from what the student took for the right-hand side.
  double residual_rounding(const Eigen::VectorXd& lambda) const;
};

// n particles, about 1 apart and of masses from 0.1 to 10, in a chain of n - 1 rods. They move, other forces
// pull at them, and no rod has its length; there is no feedback.
ConstrainedSystem random_chain(Random& random, int n);

// A wire for the particle i, which is not on it.
void add_wire(Random& random, ConstrainedSystem& system, int i);

// The system with its rods' and its wires' sizes such that C = 0.
ConstrainedSystem held(ConstrainedSystem system);

// The same system where nothing moves.
ConstrainedSystem at_rest(ConstrainedSystem system);

// Chains of rods, long and short.
std::vector<ConstrainedSystem> chains(Random& random);

// Beads that nothing else holds, the wires not in their order.
std::vector<ConstrainedSystem> beads(Random& random);

// Chains with a bead at either end.
std::vector<ConstrainedSystem> hung_chains(Random& random);

// All distances of so many particles.
ConstrainedSystem rigid_body(Random& random, int n);

}  // namespace grader
