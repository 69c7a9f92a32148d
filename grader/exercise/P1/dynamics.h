// STAFF ONLY. Accelerations that P1's suite serves: a linear one, a coupled one, an uncoupled one.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "grader/suite/random.h"
#include "particles/explicit_integrators.h"

namespace grader::p1 {

// a = -omega^2 x.
class Oscillator : public particles::Dynamics {
 public:
  explicit Oscillator(double omega) : omega_(omega) {}
  void acceleration(particles::Input x, particles::Input /*v*/, particles::Output a) override {
    a = -omega_ * omega_ * x;
  }

 private:
  double omega_;
};

// a = A sin(x) + B sin(v), entry by entry: nonlinear, and every entry depends on all others. Pinned particles
// have rows of zeros.
class Waves : public particles::Dynamics {
 public:
  Waves(Random& random, int n) : A(3 * n, 3 * n), B(3 * n, 3 * n) {
    for (Eigen::MatrixXd* matrix : {&A, &B})
      for (double& entry : matrix->reshaped()) entry = random.normal() / std::sqrt(3 * n);
  }
  void pin(int i) { A.middleRows(3 * i, 3).setZero(), B.middleRows(3 * i, 3).setZero(); }

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    a = A * x.array().sin().matrix() + B * v.array().sin().matrix();
  }

  Eigen::MatrixXd A, B;
};

// a = -c sin(x), with its own c for each coordinate of a particle: uncoupled, and reversible in time.
class Pendulums : public particles::Dynamics {
 public:
  explicit Pendulums(Random& random)
      : strength_(random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2)) {}
  void acceleration(particles::Input x, particles::Input /*v*/, particles::Output a) override {
    for (Eigen::Index i = 0; i < x.size(); ++i) a[i] = -strength_[i % 3] * std::sin(x[i]);
  }

 private:
  Eigen::Vector3d strength_;
};

}  // namespace grader::p1
