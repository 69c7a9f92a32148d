// The systems that the checks of H4 and H6 solve: chains of springs, drag, and matrices as tables.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "derivative.h"
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

}  // namespace checks
