#include "particles/system.h"

#include "particles/require.h"

namespace particles {

ParticleSystem::ParticleSystem(const Particles& particles, const Force& force)
    : force_(force), inverse_mass_(3 * particles.count()) {
  for (int i = 0; i < particles.count(); ++i)
    require(particles.mass[i] > 0, "ParticleSystem: mass", particles.mass[i], "> 0");
  require(static_cast<int>(particles.pinned.size()) == particles.count(), "ParticleSystem: size of pinned",
          static_cast<double>(particles.pinned.size()), "the number of masses");
  for (int i = 0; i < particles.count(); ++i) {
    inverse_mass_.segment<3>(3 * i).setConstant(1 / particles.mass[i]);
    if (particles.is_pinned(i)) pinned_.push_back(i);
  }
}

void ParticleSystem::acceleration(Input x, Input v, Output a) {
  a.setZero();
  force_.add_force(x, v, a);
  a.array() *= inverse_mass_.array();
  for (int i : pinned_) a.segment<3>(3 * i).setZero();
}

double kinetic_energy(const Particles& particles, Input v) {
  double energy = 0;
  for (int i = 0; i < particles.count(); ++i)
    energy += 0.5 * particles.mass[i] * v.segment<3>(3 * i).squaredNorm();
  return energy;
}

Vector3d momentum(const Particles& particles, Input v) {
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < particles.count(); ++i) sum += particles.mass[i] * v.segment<3>(3 * i);
  return sum;
}

Vector3d angular_momentum(const Particles& particles, Input x, Input v, const Vector3d& about) {
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < particles.count(); ++i) {
    const Vector3d arm = x.segment<3>(3 * i) - about;
    sum += particles.mass[i] * arm.cross(Vector3d(v.segment<3>(3 * i)));
  }
  return sum;
}

Vector3d total_force(Input f) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < f.size(); k += 3) sum += f.segment<3>(k);
  return sum;
}

Vector3d total_torque(Input x, Input f, const Vector3d& about) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < f.size(); k += 3) {
    const Vector3d arm = x.segment<3>(k) - about;
    sum += arm.cross(Vector3d(f.segment<3>(k)));
  }
  return sum;
}

}  // namespace particles
