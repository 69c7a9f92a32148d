// The systems that the checks of H4 and H6 solve: chains of springs, forces that count, and a system with what came of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "derivative.h"
#include "particles/implicit_euler.h"
#include "particles/springs.h"

namespace checks {

// Particles of 1e-7 kg, 1 cm apart along x, the first one pinned; springs between them, of 1e-3 N/m if nothing else is said, the
// first one stretched by 1 mm. With h = 1/60 s, h^2 k/m is 2.8.
struct Chain {
  particles::Particles particles;
  particles::State state;
  std::vector<particles::Spring> springs;

  explicit Chain(double stiffness = 1e-3, int count = 60)
      : particles{Eigen::VectorXd::Constant(count, 1e-7), std::vector<char>(count, 0)},
        state{Eigen::VectorXd::Zero(3 * count), Eigen::VectorXd::Zero(3 * count)} {
    particles.pinned[0] = 1;
    for (int i = 1; i < count; ++i) {
      state.x[3 * i] = 0.01 * i + 0.001;
      springs.push_back({i - 1, i, stiffness, 0.01});
    }
  }

  // Springs between particles that are seven apart. The band does not know of them.
  void tie(double stiffness, double rest_length) {
    for (int i = 7; i < particles.count(); ++i) springs.push_back({i - 7, i, stiffness, rest_length});
  }
};

// Springs, and the band of those between neighbours; with a reach of 2, of those between neighbours' neighbours, too.
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

// Another force, which counts how often it is asked for itself and for a product with df/dv.
class CountedForce : public particles::Force {
 public:
  explicit CountedForce(const particles::Force& force) : force_(force) {}

  double energy(particles::Input x) const override { return force_.energy(x); }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    ++forces;
    force_.add_force(x, v, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    force_.add_dfdx(x, v, dx, df);
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    ++products;
    force_.add_dfdv(x, v, dv, df);
  }
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double by_dfdv,
                solver::BlockBand& band, particles::Scratch work) const override {
    return force_.add_band(x, v, by_dfdx, by_dfdv, band, work);
  }

  mutable int forces = 0, products = 0;

 private:
  const particles::Force& force_;
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

// a (f + b df/dx v), and 0 where particles are pinned.
inline Eigen::VectorXd right_side(const particles::Force& force, const particles::Particles& particles,
                                  const particles::State& state, double a, double b) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(state.x.size());
  force.add_dfdx(state.x, state.v, Eigen::VectorXd(b * state.v), sum);
  force.add_force(state.x, state.v, sum);
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) sum.segment<3>(3 * i) *= 0;
  return a * sum;
}

// The system of a step of h seconds, solved.
struct Solved {
  Eigen::MatrixXd A;
  Eigen::VectorXd rhs, dv;
  particles::SolveReport report;
  int products = 0;  // with df/dv

  double left() const { return (rhs - A * dv).norm(); }
  // Rounding of a residual: sums of some 15 terms, and as much for the numbers in them.
  double rounding() const { return 0x1p-48 * (A.norm() * dv.norm() + rhs.norm()); }
};

inline Solved solved(const particles::Force& force, const particles::Particles& particles,
                     const particles::State& state, double h, double tolerance) {
  Solved system{table(force, particles, state, h, h),
                right_side(force, particles, state, h, h),
                Eigen::VectorXd::Constant(state.x.size(), 1e3),
                {}};
  const CountedForce counted(force);
  Eigen::MatrixXd scratch = Eigen::MatrixXd::Constant(state.x.size(), particles::kImplicitScratch, 1e3);
  system.report = solve_implicit(counted, particles, state, h, h, tolerance, system.dv, scratch);
  system.products = counted.products;
  return system;
}

// ConjGrad takes a product for each step, one more in each call, and one for every 64 steps; each residual is another one.
// A program that writes the matrix out takes 3n.
inline void expect_all_steps_reported(const Solved& system) {
  const int steps = system.report.steps, others = system.products - steps - steps / 64;
  EXPECT_TRUE((others >= 0 && others <= 2 * particles::kMostSolves) ||
              system.products <= system.dv.size() + 4)
      << "the report says " << steps << " steps, of all calls of ConjGrad together, but there were "
      << system.products << " products with df/dv";
}

}  // namespace checks
