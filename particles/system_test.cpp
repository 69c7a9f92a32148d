// The conserved quantities of a system of particles, and its interface for integrators.
#include "particles/system.h"

#include <gtest/gtest.h>

#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/springs.h"

namespace particles_tests {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using particles::Particles;
using particles::ParticleSystem;

Particles three() {
  return {Vector3d(0.5, 2, 4), {0, 1, 0}};
}

TEST(ParticleSystem, AcceleratesByForceOverMassButNotThePinned) {
  particles::ForceSum force;
  force.emplace<particles::Gravity>(three().mass, Vector3d(0, 0, -9.81));
  force.emplace<particles::DampedSprings>(std::vector<particles::Spring>{{0, 1, 8, 1}, {1, 2, 8, 1}});
  const Particles particles = three();
  ParticleSystem system(particles, force);
  VectorXd x(9), a = VectorXd::Constant(9, NAN);
  x << 2, 0, 0, 0, 0, 0, 0, 3, 0;
  system.acceleration(x, VectorXd::Zero(9), a);
  // Springs pull by 8 and 16 N, masses are 0.5 and 4 kg.
  EXPECT_EQ(a, (VectorXd(9) << -16, 0, -9.81, 0, 0, 0, 0, -4, -9.81).finished());
}

TEST(ParticleSystem, RefusesWhatHasNoMass) {
  const particles::ForceSum none;
  for (double mass : {0.0, -1.0, double{NAN}}) {
    const Particles particles{Eigen::VectorXd::Constant(1, mass), {0}};
    EXPECT_THROW(ParticleSystem(particles, none), std::invalid_argument);
  }
  const Particles short_of_pinned{Eigen::VectorXd::Constant(2, 1), {0}};
  EXPECT_THROW(ParticleSystem(short_of_pinned, none), std::invalid_argument);
}

TEST(Momenta, AreSumsOverParticles) {
  VectorXd x(9), v(9);
  x << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  v << 0, 2, 0, 0, 0, 1, 3, 0, 0;
  EXPECT_EQ(particles::kinetic_energy(three(), v), 0.5 * (0.5 * 4 + 2 * 1 + 4 * 9));
  EXPECT_EQ(particles::momentum(three(), v), Vector3d(12, 1, 2));
  EXPECT_EQ(particles::angular_momentum(three(), x, v), Vector3d(2, 12, 1));
  // About another point p: L - p x P.
  const Vector3d p(1, -2, 0.5);
  EXPECT_LE(
      (particles::angular_momentum(three(), x, v, p) - (Vector3d(2, 12, 1) - p.cross(Vector3d(12, 1, 2))))
          .norm(),
      1e-14);
  EXPECT_EQ(particles::total_force(v), Vector3d(3, 2, 1));
  EXPECT_EQ(particles::total_torque(x, v), Vector3d(1, 3, 2));
}

}  // namespace
}  // namespace particles_tests
