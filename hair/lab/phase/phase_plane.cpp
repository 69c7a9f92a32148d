#include "hair/lab/phase/phase_plane.h"

#include <cmath>
#include <complex>

#include "particles/explicit_integrators.h"

namespace hair::phase {

namespace {

// A particle whose third number is the angle: code that forgets the factor 3 does not move it.
class Pendulum : public particles::Dynamics {
 public:
  void acceleration(particles::Input x, particles::Input, particles::Output a) override {
    ++evaluations;
    a.setZero();
    a[2] = -std::sin(x[2]);
  }
  long evaluations = 0;
};

using Method = void (*)(particles::Dynamics&, double, particles::Output, particles::Output,
                        particles::Scratch);

void play(Method method, Motion& motion) {
  Pendulum pendulum;
  Eigen::VectorXd x = Eigen::Vector3d(0, 0, kBegin), v = Eigen::VectorXd::Zero(3);
  Eigen::MatrixXd scratch = Eigen::MatrixXd::Zero(3, particles::kIntegratorScratch);
  motion.states.push_back({x[2], v[2]});
  for (int step = 0; step < kSteps && std::isfinite(x[2]) && std::isfinite(v[2]); ++step) {
    method(pendulum, kStep, x, v, scratch);
    motion.states.push_back({x[2], v[2]});
  }
  motion.evaluations = pendulum.evaluations;
}

// A method of this order multiplies small swings by the Taylor polynomial of exp(ih) in each step.
double energy_of_small_swings(int order) {
  std::complex<double> factor = 1, term = 1;
  for (int k = 1; k <= order; ++k) {
    term *= std::complex<double>(0, kStep) / static_cast<double>(k);
    factor += term;
  }
  return std::pow(std::abs(factor), 2 * kSteps);
}

}  // namespace

double State::energy() const {
  return (rate * rate / 2 + 1 - std::cos(angle)) / (1 - std::cos(kBegin));
}

std::vector<Motion> phase_plane() {
  std::vector<Motion> motions = {
      {"forward Euler", "It winds outwards and leaves the picture: each step gains energy.", 1,
       energy_of_small_swings(1)},
      {"symplectic Euler",
       "It stays on a closed curve, which leans to one side: the energy goes up and down, and is never lost.",
       1},
      {"midpoint", "It winds outwards slowly: the error of a step is of the third order.", 2,
       energy_of_small_swings(2)},
      {"Runge-Kutta 4", "It stays on the exact curve, as far as one can see.", 4, energy_of_small_swings(4)}};
  constexpr Method kMethods[] = {particles::forward_euler, particles::symplectic_euler, particles::midpoint,
                                 particles::runge_kutta_4};
  for (std::size_t i = 0; i < motions.size(); ++i) play(kMethods[i], motions[i]);
  return motions;
}

}  // namespace hair::phase
