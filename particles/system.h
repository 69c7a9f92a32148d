// Particles under a force: the system for the integrators, and its conserved quantities.
#pragma once

#include "particles/dynamics.h"
#include "particles/force.h"
#include "particles/state.h"

namespace particles {

// a = f(x, v) / m, and 0 for pinned particles. Keeps references to both arguments, which must outlive it.
class ParticleSystem : public Dynamics {
 public:
  // Throws std::invalid_argument if a mass is not > 0, or if `pinned` has another size than `mass`.
  ParticleSystem(const Particles& particles, const Force& force);

  void acceleration(Input x, Input v, Output a) override;

 private:
  const Particles& particles_;
  const Force& force_;
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
