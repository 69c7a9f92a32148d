// The systems that the checks of H4 and H6 solve: chains of springs, drag, and matrices as tables; and a mass
// that turns on a spring around a pinned particle, for a revolution.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "derivative.h"
#include "hair/geometric_term.h"
#include "ordinary.h"
#include "particles/implicit_euler.h"
#include "particles/springs.h"

namespace checks {

// A strand of about 1e-7 kg a particle and 1 cm a segment, its first particle pinned and at rest; springs
// between neighbours, of about `stiffness` N/m, stretched by up to a tenth. With 1e-3 N/m and h = 1/60 s, h^2
// k/m is 1 to 10.
struct Chain {
  hair::Strand strand;
  particles::Particles particles;
  particles::State state;
  std::vector<particles::Spring> springs;

  Chain(double stiffness, int count) {
    Scatter scatter(count);
    strand = ordinary_strand(scatter, count);
    state.x = 0.01 * ordinary_positions(scatter, strand, 1, 1.1, 0.3);
    state.v = 0.1 * ordinary_numbers(scatter, 3 * count, -1, 1);
    state.v.head<3>().setZero();
    strand.mass *= 1e-7;
    strand.rest_length *= 0.01;
    particles = {strand.mass, std::vector<char>(static_cast<std::size_t>(count), 0)};
    particles.pinned[0] = 1;
    for (int i = 0; i < count - 1; ++i) {
      const double k = stiffness * ordinary_number(scatter, 0.7, 1.5);
      springs.push_back({i, i + 1, k, strand.rest_length[i]});
    }
  }
};

// Springs that know the band of their matrix: that of neighbours, and with a reach of 2 that of neighbours'
// neighbours, too.
class BandedSprings : public particles::DampedSprings {
 public:
  explicit BandedSprings(const std::vector<particles::Spring>& springs, int reach = 1)
      : DampedSprings(springs, particles::Products::definite), reach_(reach), springs_(springs) {}

  bool add_band(particles::Input x, particles::Input, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch) const override {
    for (const particles::Spring& spring : springs_) {
      if (spring.j > spring.i + reach_) continue;
      const Eigen::Vector3d e = x.segment<3>(3 * spring.j) - x.segment<3>(3 * spring.i);
      const Eigen::Matrix3d along = e * e.transpose() / e.squaredNorm();
      const double turn = std::max(1 - spring.rest_length / e.norm(), 0.0);
      const Eigen::Matrix3d K = spring.stiffness * (along + turn * (Eigen::Matrix3d::Identity() - along));
      band.block(spring.i, 0) -= by_dfdx * K;
      band.block(spring.j, 0) -= by_dfdx * K;
      band.block(spring.j, spring.j - spring.i) += by_dfdx * K;
    }
    return true;
  }

 private:
  int reach_;
  std::vector<particles::Spring> springs_;
};

// f = -x^2 v^3 of each number: drag whose derivatives depend on place and velocity.
class ThickAir : public particles::Force {
 public:
  using Input = particles::Input;
  using Output = particles::Output;

  double energy(Input) const override { return 0; }
  void add_force(Input x, Input v, Output f) const override {
    f.array() -= x.array().square() * v.array().cube();
  }
  void add_dfdx(Input x, Input v, Input dx, Output df) const override {
    df.array() -= 2 * x.array() * v.array().cube() * dx.array();
  }
  void add_dfdv(Input x, Input v, Input dv, Output df) const override {
    df.array() -= 3 * (x.array() * v.array()).square() * dv.array();
  }
};

// A matrix that is given as a table, and counts its products.
class Table : public implicitMatrix {
 public:
  explicit Table(const Eigen::MatrixXd& entries) : A(entries) {}

  void matVecMult(double x[], double b[]) override {
    ++products;
    Eigen::Map<Eigen::VectorXd>(b, A.rows()) = A * Eigen::Map<const Eigen::VectorXd>(x, A.cols());
  }

  Eigen::MatrixXd A;
  int products = 0;
};

inline Eigen::VectorXd times(implicitMatrix& matrix, Eigen::VectorXd x) {
  const Eigen::VectorXd before = x;
  Eigen::VectorXd b = Eigen::VectorXd::Constant(x.size(), std::numeric_limits<double>::quiet_NaN());
  matrix.matVecMult(x.data(), b.data());
  EXPECT_EQ(x, before) << "matVecMult changed its input";
  return b;
}

// The matrix as a table, by products with unit vectors.
inline Eigen::MatrixXd table(const particles::Force& force, const particles::Particles& particles,
                             const particles::State& state, double a, double b) {
  auto matrix = implicit_matrix(force, particles, state, a, b);
  Eigen::MatrixXd A(state.x.size(), state.x.size());
  for (int j = 0; j < A.cols(); ++j) A.col(j) = times(*matrix, Eigen::VectorXd::Unit(A.cols(), j));
  return A;
}

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
