// A pinned particle, a spring and a second particle that turns around the first: the system, its revolution,
// and what is measured of it, for the checks of H4 and H6.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "hair/geometric_term.h"
#include "particles/force.h"
#include "particles/state.h"

namespace checks {

// A spring of stiffness k (N/m) and rest length l0 between particles 0 and 1, and drag -c v on both. It
// counts its evaluations and products.
class Spring : public particles::Force {
 public:
  Spring(double k, double l0, hair::GeometricTerm term, double c = 0) : k_(k), l0_(l0), c_(c), term_(term) {}

  double energy(particles::Input x) const override {
    const double stretch = along(x).norm() - l0_;
    return k_ * stretch * stretch / 2;
  }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    ++forces;
    const Eigen::Vector3d pull = k_ * (along(x).norm() - l0_) * along(x).normalized();
    f.head<3>() += pull;
    f.tail<3>() -= pull;
    f -= c_ * v;
  }
  void add_dfdx(particles::Input x, particles::Input, particles::Input dx,
                particles::Output df) const override {
    ++products_x;
    const Eigen::Vector3d u = along(x).normalized(), d = along(dx);
    double turn = 1 - l0_ / along(x).norm();
    if (term_ == hair::GeometricTerm::filtered) turn = std::max(turn, 0.0);
    if (term_ == hair::GeometricTerm::dropped) turn = 0;
    const Eigen::Vector3d pull = k_ * (u.dot(d) * u + turn * (d - u.dot(d) * u));
    df.head<3>() += pull;
    df.tail<3>() -= pull;
  }
  void add_dfdv(particles::Input, particles::Input, particles::Input dv,
                particles::Output df) const override {
    ++products_v;
    df -= c_ * dv;
  }

  mutable int forces = 0, products_x = 0, products_v = 0;

 private:
  static Eigen::Vector3d along(particles::Input x) { return x.tail<3>() - x.head<3>(); }

  double k_, l0_, c_;
  hair::GeometricTerm term_;
};

// Takes a step of h seconds.
using StepOf =
    std::function<void(const particles::Force&, const particles::Particles&, double h, particles::State&)>;

struct Revolution {
  double momentum;  // L/L0, the part of the angular momentum about the anchor that is left
  double length;    // the largest |l - l0| / l0 after a step
  double radial;    // the largest velocity along the spring after a step, m/s
};

// A mass of 0.7 kg turns on a spring of 0.3 m around its anchor, at rest length and Omega = 2 pi: one
// revolution with h = 1/60 s and k/m = 1e8 / s^2. Prints its row of the table in the assignment.
inline Revolution revolve(const char* method, hair::GeometricTerm term, const StepOf& step) {
  const double m = 0.7, l0 = 0.3, turn = 2 * std::numbers::pi, h = 1.0 / 60;
  const Spring spring(1e8 * m, l0, term);
  const particles::Particles particles{Eigen::Vector2d(m, m), {1, 0}};
  particles::State state{Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  state.x[3] = l0;
  state.v[4] = turn * l0;
  Revolution result{0, 0, 0};
  for (int i = 0; i < 60; ++i) {
    step(spring, particles, h, state);
    const Eigen::Vector3d x = state.x.tail<3>(), v = state.v.tail<3>();
    result.length = std::max(result.length, std::abs(x.norm() / l0 - 1));
    result.radial = std::max(result.radial, std::abs(x.dot(v)) / x.norm());
  }
  const Eigen::Vector3d x = state.x.tail<3>(), v = state.v.tail<3>();
  result.momentum = x.cross(v)[2] / (l0 * l0 * turn);
  std::printf(" %s: L/L0 %.4f, length %.1e, radial %.1e m/s;", method, result.momentum, result.length,
              result.radial);
  return result;
}

}  // namespace checks
