// STAFF ONLY. Symplectic Euler keeps w^2 x^2 + v^2 - s w x v, with s = h w (Hairer, Lubich and Wanner,
// "Geometric Numerical Integration", sections I.1 and IX.3). The public checks test the promises of
// particles/explicit_integrators.h, and studies the methods' orders.

#include "particles/explicit_integrators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/state.h"

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

class Oscillator : public Dynamics {
 public:
  explicit Oscillator(double omega) : omega_(omega) {}
  void acceleration(Input x, Input, Output a) override { a = -omega_ * omega_ * x; }

 private:
  double omega_;
};

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
