// STAFF ONLY. The four methods behave as theory predicts. The public checks test the promises of
// particles/explicit_integrators.h.
//
// An oscillator z' = i w z, z = w x - i v, is enough: a step multiplies it by R, with s = h w.
//
//   midpoint  |R|^2 = 1 + s^4 / 4      RK4  |R|^2 = 1 - s^6 / 72 + s^8 / 576
//
// Symplectic Euler keeps w^2 x^2 + v^2 - s w x v and turns by 2 asin(s/2) a step. (Hairer, Lubich and Wanner,
// "Geometric Numerical Integration", sections I.1 and IX.3.)

#include "particles/explicit_integrators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/state.h"
#include "solver/test_numbers.h"

namespace reference_tests {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using particles::Dynamics;
using particles::Input;
using particles::kIntegratorScratch;
using particles::Output;
using particles::Scratch;
using particles::State;

struct Method {
  const char* name;
  int order;
  void (*step)(Dynamics&, double, Output, Output, Scratch);
};

const Method kMethods[] = {{"ForwardEuler", 1, particles::forward_euler},
                           {"SymplecticEuler", 1, particles::symplectic_euler},
                           {"Midpoint", 2, particles::midpoint},
                           {"RungeKutta4", 4, particles::runge_kutta_4}};

class Oscillator : public Dynamics {
 public:
  explicit Oscillator(double omega) : omega_(omega) {}
  void acceleration(Input x, Input, Output a) override { a = -omega_ * omega_ * x; }

 private:
  double omega_;
};

void run(const Method& method, Dynamics& dynamics, double h, int steps, State& state) {
  MatrixXd scratch = MatrixXd::Constant(state.x.size(), kIntegratorScratch, kNaN);
  for (int i = 0; i < steps; ++i) method.step(dynamics, h, state.x, state.v, scratch);
}

TEST(Order, Is1And1And2And4OnAnOscillator) {
  for (const Method& method : kMethods) {
    // The error is that of the full state at omega t = 2, where sin 2 = 0.91.
    const auto error = [&](int steps) {
      Oscillator oscillator(5);
      State state{VectorXd::Constant(3, 0.4), VectorXd::Constant(3, 3)};
      run(method, oscillator, 0.4 / steps, steps, state);
      return std::hypot(state.x[0] - (0.4 * std::cos(2) + 0.6 * std::sin(2)),
                        state.v[0] / 5 - (0.6 * std::cos(2) - 0.4 * std::sin(2)));
    };
    for (int steps : {64, 128, 256}) {
      const double order = std::log2(error(steps) / error(2 * steps));
      // The next term of the error is smaller by h omega, 1/32 and less, times at most 2.
      EXPECT_NEAR(order, method.order, 0.05) << method.name << ", " << steps << " steps";
      if (steps == 256)
        std::printf("%-16s observed order %.4f, error after 256 steps %.3e\n", method.name, order,
                    error(256));
    }
  }
}

TEST(SymplecticEuler, KeepsEnergyBoundedOverAMillionSteps) {
  for (double s : {0.1, 1.1, 1.9}) {
    Oscillator oscillator(1);
    State state{VectorXd::Unit(3, 0), VectorXd::Constant(3, 0.3)};
    MatrixXd scratch(3, kIntegratorScratch);
    double least = INFINITY, most = 0;
    for (int i = 0; i < 1000000; ++i) {
      particles::symplectic_euler(oscillator, s, state.x, state.v, scratch);
      const double energy = state.x[0] * state.x[0] + state.v[0] * state.v[0];
      least = std::min(least, energy);
      most = std::max(most, energy);
    }
    const double bound = (1 + s / 2) / (1 - s / 2);
    std::printf("symplectic Euler, h omega = %.1f: Emax/Emin = %.9f after 1e6 steps, bound %.9f\n", s,
                most / least, bound);
    // Rounding walks at random: about sqrt(1e6) u of the energy, times what the bound magnifies.
    EXPECT_LE(most / least, bound * (1 + 1e-10)) << s;
    EXPECT_GE(most / least, bound * (1 - 1e-3)) << "a million phases come close to the extremes";
  }
}

}  // namespace
}  // namespace reference_tests
