// STAFF ONLY. P2: a hidden case of constraints over many steps.
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "grader/exercise/P2/answers.h"
#include "grader/exercise/P2/cases.h"
#include "particles/explicit_integrators.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// What the student's lambda makes of the particles, for an integrator.
class StudentsDynamics : public particles::Dynamics {
 public:
  StudentsDynamics(Trial& trial, ConstrainedSystem system) : trial_(trial), system_(std::move(system)) {}

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    system_.state = {x, v};
    const VectorXd lambda = solve(trial_, system_).lambda;
    a = system_.inverse_masses().cwiseProduct(system_.f + system_.jacobian().transpose() * lambda);
  }

 private:
  Trial& trial_;
  ConstrainedSystem system_;
};

}  // namespace

// A double pendulum, swung for 0.1 s. Nothing is faster than w = 20/s here, so that RK4 is off by at most 25
// steps of (h w)^5 / 120 = 7e-7 of all sizes. Its masses differ and its rods are pulled, so that what goes
// wrong shows.
void energy(Trial& trial) {
  Random& random = trial.random;
  const double g = 9.81;
  ConstrainedSystem swing = random_chain(random, 3);
  swing.name = "double pendulum";
  swing.particles.mass = Vector3d(1, random.uniform(2, 4), random.uniform(0.2, 0.4));
  swing.particles.pinned[0] = 1;
  const double turn = random.uniform(0, 6);
  for (int i = 1; i < 3; ++i) {
    const double down = random.uniform(0.3, 0.8);
    swing.state.x.segment<3>(3 * i) =
        swing.state.x.segment<3>(3 * i - 3) +
        random.uniform(0.7, 1.3) * Vector3d(std::sin(down) * std::cos(turn * i),
                                            std::sin(down) * std::sin(turn * i), -std::cos(down));
  }
  const Vector3d spin = random.uniform(1, 3) * Vector3d(std::sin(turn), std::cos(turn), 0);
  for (int i = 0; i < 3; ++i)
    swing.state.v.segment<3>(3 * i) =
        spin.cross(Vector3d(swing.state.x.segment<3>(3 * i) - swing.state.x.head<3>()));
  swing = held(swing);
  swing.f.setZero();
  for (int i = 0; i < 3; ++i) swing.f[3 * i + 2] = -g * swing.particles.mass[i];

  const auto energy = [&] {
    double sum = -swing.f.dot(swing.state.x);
    for (int i = 0; i < 3; ++i)
      sum += 0.5 * swing.particles.mass[i] * swing.state.v.segment<3>(3 * i).squaredNorm();
    return sum;
  };
  const double before = energy();
  StudentsDynamics dynamics(trial, swing);
  MatrixXd scratch(9, particles::kIntegratorScratch);
  for (int step = 0; step < 25; ++step)
    particles::runge_kutta_4(dynamics, 0.004, swing.state.x, swing.state.v, scratch);
  const double scale = g * swing.particles.mass.tail<2>().sum();
  trial.expect_at_most(std::abs(energy() - before), kTolerance * scale,
                       "the energy that a swing gains or loses");
  trial.expect_at_most(swing.values().norm(), kTolerance, "what a swing's rods are off their lengths");
}

}  // namespace grader::p2
