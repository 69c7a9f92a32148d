// Particles under a force: the system for the integrators, and its conserved quantities.
#pragma once

#include <vector>

#include "particles/dynamics.h"
#include "particles/force.h"
#include "particles/state.h"

namespace particles {

// a = f(x, v) / m, and 0 for pinned particles. Keeps a reference to the force, which must outlive it, and
// copies what it needs of the particles.
class ParticleSystem : public Dynamics {
 public:
  // Throws std::invalid_argument if a mass is not > 0, or if `pinned` has another size than `mass`.
  ParticleSystem(const Particles& particles, const Force& force);

  void acceleration(Input x, Input v, Output a) override;

 private:
  const Force& force_;
  Eigen::VectorXd inverse_mass_;  // 3n, 1 / kg: the same three times for each particle
  std::vector<int> pinned_;
};

// The parameters of a step, common to all methods.
struct StepOptions {
  double h;          // s
  double tolerance;  // relative tolerance of implicit solves
};

// Sums over all particles, including pinned ones.
double kinetic_energy(const Particles& particles, Input v);              // J
Vector3d momentum(const Particles& particles, Input v);                  // kg m/s
Vector3d angular_momentum(const Particles& particles, Input x, Input v,  // kg m^2/s
                          const Vector3d& about = Vector3d::Zero());

// The sum of forces, and their torque about a point.
Vector3d total_force(Input f);                                                      // N
Vector3d total_torque(Input x, Input f, const Vector3d& about = Vector3d::Zero());  // N m

}  // namespace particles
