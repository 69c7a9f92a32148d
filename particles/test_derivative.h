// Compares a force with the differences of its energy, and its products with the differences of the force, by
// central differences (g(e) - g(-e)) / 2e. With the step e = 1e-5 and lengths of about 1, their errors are
// e^2/6 g''' and u |g| / e, about 1e-10 and 1e-11 of g: the bound 1e-6 allows third derivatives 1e4 times as
// large as g.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "particles/force.h"

namespace particles_tests {

using Eigen::Vector3d;
using Eigen::VectorXd;

inline constexpr double kStep = 1e-5, kBound = 1e-6;

// n numbers between -1 and 1, the same ones for the same seed.
inline VectorXd scattered(int n, unsigned seed) {
  std::mt19937 engine(seed);
  VectorXd values(n);
  for (int i = 0; i < n; ++i) values[i] = 2 * (engine() / 4294967295.0) - 1;
  return values;
}

inline VectorXd force_at(const particles::Force& force, const VectorXd& x, const VectorXd& v) {
  VectorXd f = VectorXd::Zero(x.size());
  force.add_force(x, v, f);
  return f;
}

inline VectorXd dfdx_at(const particles::Force& force, const VectorXd& x, const VectorXd& v,
                        const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  force.add_dfdx(x, v, dx, df);
  return df;
}

inline VectorXd dfdv_at(const particles::Force& force, const VectorXd& x, const VectorXd& v,
                        const VectorXd& dv) {
  VectorXd df = VectorXd::Zero(x.size());
  force.add_dfdv(x, v, dv, df);
  return df;
}

inline void expect_near(const VectorXd& actual, const VectorXd& expected, const char* what) {
  const double error = (actual - expected).norm(), bound = kBound * expected.norm() + 1e-14;
  EXPECT_LE(error, bound) << what << "\nactual:   " << actual.transpose()
                          << "\nexpected: " << expected.transpose();
}

// f = -dE/dx, one coordinate after the other. v = 0, so that damping has no effect.
inline void expect_force_is_minus_gradient(const particles::Force& force, const VectorXd& x) {
  VectorXd expected(x.size()), moved = x;
  for (int i = 0; i < x.size(); ++i) {
    moved[i] = x[i] + kStep;
    const double after = force.energy(moved);
    moved[i] = x[i] - kStep;
    expected[i] = -(after - force.energy(moved)) / (2 * kStep);
    moved[i] = x[i];
  }
  expect_near(force_at(force, x, VectorXd::Zero(x.size())), expected, "f = -dE/dx");
}

inline void expect_products_are_derivatives(const particles::Force& force, const VectorXd& x,
                                            const VectorXd& v) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const VectorXd d = scattered(static_cast<int>(x.size()), seed);
    expect_near(dfdx_at(force, x, v, d),
                (force_at(force, x + kStep * d, v) - force_at(force, x - kStep * d, v)) / (2 * kStep),
                "(df/dx) dx");
    expect_near(dfdv_at(force, x, v, d),
                (force_at(force, x, v + kStep * d) - force_at(force, x, v - kStep * d)) / (2 * kStep),
                "(df/dv) dv");
  }
}

// a'Kb = b'Ka for the matrix K = df/dx of the products, up to the rounding of the sums.
inline void expect_symmetric_dfdx(const particles::Force& force, const VectorXd& x, const VectorXd& v) {
  const VectorXd a = scattered(static_cast<int>(x.size()), 4), b = scattered(static_cast<int>(x.size()), 5);
  const VectorXd Ka = dfdx_at(force, x, v, a), Kb = dfdx_at(force, x, v, b);
  EXPECT_NEAR(a.dot(Kb), b.dot(Ka), 1e-14 * (Ka.norm() * b.norm() + Kb.norm() * a.norm()));
}

// The matrix df/dx, column by column from products.
inline Eigen::MatrixXd dfdx_matrix(const particles::Force& force, const VectorXd& x, const VectorXd& v) {
  Eigen::MatrixXd K(x.size(), x.size());
  for (int i = 0; i < x.size(); ++i) K.col(i) = dfdx_at(force, x, v, VectorXd::Unit(x.size(), i));
  return K;
}

}  // namespace particles_tests
