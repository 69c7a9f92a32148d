// Particles under a force, as what integrators see, and what such a system conserves.
#pragma once

#include "particles/dynamics.h"
#include "particles/force.h"
#include "particles/state.h"

namespace particles {

// a = f(x, v) / m, and 0 for pinned particles. Refers to both arguments, which must outlive it.
class ParticleSystem : public Dynamics {
 public:
  // Throws std::invalid_argument for a mass that is not > 0, or another number of `pinned`.
  ParticleSystem(const Particles& particles, const Force& force);

  void acceleration(Input x, Input v, Output a) override;

 private:
  const Particles& particles_;
  const Force& force_;
};

// Sums over all particles, those that are pinned included.
double kinetic_energy(const Particles& particles, Input v);              // J
Vector3d momentum(const Particles& particles, Input v);                  // kg m/s
Vector3d angular_momentum(const Particles& particles, Input x, Input v,  // kg m^2/s
                          const Vector3d& about = Vector3d::Zero());

// The same of forces instead of momenta: what they add up to, and the torque about a point.
Vector3d total_force(Input f);                                                      // N
Vector3d total_torque(Input x, Input f, const Vector3d& about = Vector3d::Zero());  // N m

}  // namespace particles
