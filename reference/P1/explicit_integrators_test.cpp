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

#include "particles/drag.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/springs.h"
#include "particles/system.h"
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

const Method kForwardEuler = {"ForwardEuler", 1, particles::forward_euler};
const Method kSymplecticEuler = {"SymplecticEuler", 1, particles::symplectic_euler};
const Method kMidpoint = {"Midpoint", 2, particles::midpoint};
const Method kRungeKutta4 = {"RungeKutta4", 4, particles::runge_kutta_4};
const Method kMethods[] = {kForwardEuler, kSymplecticEuler, kMidpoint, kRungeKutta4};

class Oscillator : public Dynamics {
 public:
  explicit Oscillator(double omega, double damping = 0) : omega_(omega), damping_(damping) {}
  void acceleration(Input x, Input v, Output a) override { a = -omega_ * omega_ * x - damping_ * v; }

 private:
  double omega_, damping_;
};

// Four particles of different masses on damped springs under gravity, one of them pinned and pulled along.
struct Net {
  particles::Particles points{Eigen::Vector4d(0.3, 2, 0.7, 5), {0, 0, 1, 0}};
  particles::ForceSum force;
  particles::ParticleSystem system{points, force};
  State start{VectorXd(12), VectorXd(12)};

  Net() {
    force.emplace<particles::Gravity>(points.mass, Eigen::Vector3d(0, 0, -9.81));
    force.emplace<particles::Drag>(0.2 * points.mass, Eigen::Vector3d(1, 0, 0));
    force.emplace<particles::DampedSprings>(std::vector<particles::Spring>{
        {0, 1, 20, 1, 0.3}, {1, 2, 30, 0.8, 0.2}, {2, 3, 40, 1.2}, {3, 0, 25, 1}});
    start.x << 0, 0, 0, 1, 0.2, 0, 1.2, 1.1, 0.1, -0.1, 1, 0.3;
    start.v << 0.1, -0.4, 0.2, 0, 0.3, 0.5, 1, 2, -3, -0.2, 0.1, 0;
  }
};

void run(const Method& method, Dynamics& dynamics, double h, int steps, State& state) {
  MatrixXd scratch = MatrixXd::Constant(state.x.size(), kIntegratorScratch, kNaN);
  for (int i = 0; i < steps; ++i) method.step(dynamics, h, state.x, state.v, scratch);
}

// The energy w^2 x^2 + v^2 with w = 1, after so many steps from 1.
double energy_after(const Method& method, double s, int steps) {
  Oscillator oscillator(1);
  State state{VectorXd::Unit(3, 0), VectorXd::Zero(3)};
  run(method, oscillator, s, steps, state);
  return state.x.squaredNorm() + state.v.squaredNorm();
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

TEST(Order, IsTheSameForForcesOnMassesThatDependOnVelocity) {
  for (const Method& method : kMethods) {
    Net net;
    const auto after = [&](int steps) {
      State state = net.start;
      run(method, net.system, 0.5 / steps, steps, state);
      VectorXd both(24);
      both << state.x, state.v;
      return both;
    };
    // Differences of three runs need no known solution.
    const double order = std::log2((after(128) - after(256)).norm() / (after(256) - after(512)).norm());
    EXPECT_NEAR(order, method.order, 0.15) << method.name;
  }
}

TEST(Midpoint, GainsEnergyBySToTheFourthOver4) {
  for (double s : {0.01, 0.1, 1.0})
    EXPECT_NEAR(energy_after(kMidpoint, s, 100) / std::pow(1 + std::pow(s, 4) / 4, 100), 1, 2000 * kUnit)
        << s;
}

TEST(RungeKutta4, LosesEnergyBySToTheSixthOver72) {
  for (double s : {0.1, 1.0, 2.0})
    EXPECT_NEAR(
        energy_after(kRungeKutta4, s, 100) / std::pow(1 - std::pow(s, 6) / 72 + std::pow(s, 8) / 576, 100), 1,
        4000 * kUnit)
        << s;
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

TEST(SymplecticEuler, TurnsByTwoArcSinesOfHalfS) {
  const double s = 0.5, turn = 2 * std::asin(s / 2);
  Oscillator oscillator(1);
  State state{VectorXd::Unit(3, 0), VectorXd::Zero(3)};
  run(kSymplecticEuler, oscillator, s, 1000, state);
  // From x = 1, v = 0: x_n = cos(n turn) - tan(turn / 2) sin(n turn).
  EXPECT_NEAR(state.x[0], std::cos(1000 * turn) - std::tan(turn / 2) * std::sin(1000 * turn), 1e-12);
}

// |R| leaves 1 at once for forward Euler and midpoint, at s = 2 for symplectic Euler, and at sqrt(8) for RK4.
TEST(Stability, EndsWhereTheoryPutsIt) {
  EXPECT_LT(energy_after(kSymplecticEuler, 1.99, 100000), 1000);
  EXPECT_GT(energy_after(kSymplecticEuler, 2.01, 1000), 1e6);
  EXPECT_LT(energy_after(kRungeKutta4, 2.82, 1000), 1);
  EXPECT_GT(energy_after(kRungeKutta4, 2.84, 1000), 1e6);

  // With drag alone, v' = -c v, |R| <= 1 holds up to h c = 2, 2, 2 and 2.785.
  for (const auto& [method, limit] : {std::pair{kForwardEuler, 2.0},
                                      {kSymplecticEuler, 2.0},
                                      {kMidpoint, 2.0},
                                      {kRungeKutta4, 2.785293563}}) {
    for (double side : {0.999, 1.001}) {
      Oscillator drag(0, limit * side);
      State state{VectorXd::Zero(3), VectorXd::Ones(3)};
      run(method, drag, 1, 5000, state);
      EXPECT_EQ(std::abs(state.v[0]) < 1, side < 1) << method.name << ", h c = " << limit * side;
    }
  }
}

}  // namespace
}  // namespace reference_tests
