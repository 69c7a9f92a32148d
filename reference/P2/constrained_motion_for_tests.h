// STAFF ONLY. Particles under constraints, P2's functions on them in short, and their motion in time.
#pragma once

#include "particles/constraint_forces.h"
#include "particles/dynamics.h"

namespace reference_tests {

struct ConstrainedMotion : particles::Dynamics {
  particles::Constraints constraints;
  particles::Particles particles;
  particles::State state;
  Eigen::VectorXd f, lambda;

  // Makes x, v the state, and solves there. x and v are not parts of the state.
  void acceleration(particles::Input x, particles::Input v, particles::Output a) override;

  Eigen::VectorXd values() const;
  Eigen::VectorXd rates() const;
  Eigen::VectorXd forces(const Eigen::VectorXd& multipliers) const;  // J^T multipliers
  particles::ConstraintReport solve();                               // for lambda
  Eigen::VectorXd accelerations() const;                             // W (f + J^T lambda)
};

// n particles of masses 1, 2, 1, 2, ... along x, particle 0 pinned, with rods between neighbours.
ConstrainedMotion straight_chain(int n, double length);

}  // namespace reference_tests
