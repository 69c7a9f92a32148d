// STAFF ONLY. Compares theory's limits with the spectral radius of a step's matrix: just below a limit it is
// at most 1, just above it is more.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "hair/lab/stability/theory.h"
#include "hair/simulation/test_hairs.h"
#include "solver/dense_solve.h"

namespace reference_tests {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

// Gelfand's formula, |A^N|^(1/N) with N = 2^40: the factor between the power's norm and the radius' power has
// a logarithm of at most some tens, divided by N.
double spectral_radius(MatrixXd power) {
  double logarithm = 0;
  for (int k = 0; k < 40; ++k) {
    const double size = power.norm();
    if (size == 0) return 0;
    logarithm += std::ldexp(std::log(size), -k);
    power = (power / size * (power / size)).eval();
  }
  return std::exp(logarithm);
}

TEST(StabilityTheory, ExplicitLimitsHaveTheirClosedForms) {
  const double w = 7;
  for (const double zeta : {0.0, 0.2, 1.0, 4.0}) {
    const hair::Oscillator one{w, 2 * zeta * w};
    const double root = zeta > 1 ? std::sqrt(zeta * zeta - 1) : 0;
    EXPECT_NEAR(hair::explicit_limit(Method::forward_euler, one),
                zeta <= 1 ? 2 * zeta / w : 2 / (w * (zeta + root)), 1e-9);
    EXPECT_NEAR(hair::explicit_limit(Method::symplectic_euler, one),
                2 * (std::sqrt(1 + zeta * zeta) - zeta) / w, 1e-12);
  }
  EXPECT_EQ(hair::explicit_limit(Method::forward_euler, {w}), 0);
  EXPECT_EQ(hair::explicit_limit(Method::midpoint, {w}), 0);
  EXPECT_NEAR(hair::explicit_limit(Method::runge_kutta_4, {w}) * w, 2 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(hair::explicit_limit(Method::runge_kutta_4, {0, w}) * w, 2.785293563, 1e-8);
}

TEST(StabilityTheory, StrongDragMakesTheSlowestModeBindForwardEuler) {
  const hair::Oscillator fast{10, 16}, slow{0.1, 16};  // gamma = 1.6 omega: the fast one is not overdamped
  EXPECT_LT(hair::explicit_limit(Method::forward_euler, slow),
            hair::explicit_limit(Method::forward_euler, fast));
}

// Three masses, K and P neither commuting nor diagonal.
struct System {
  VectorXd mass = Eigen::Vector3d(1, 2, 0.5);
  MatrixXd k = (MatrixXd(3, 3) << 9, -2, 1, -2, 7, 3, 1, 3, 8).finished();
  MatrixXd p = (MatrixXd(3, 3) << 2, 1, 0, 1, 3, -1, 0, -1, 1).finished();
};

MatrixXd implicit_step(const System& s, double gamma, double h) {
  const MatrixXd m = s.mass.asDiagonal();
  const MatrixXd left = solver::dense_solve(m + h * gamma * m + h * h * s.p, MatrixXd::Identity(3, 3));
  const MatrixXd from_x = -h * left * s.k;
  const MatrixXd from_v = MatrixXd::Identity(3, 3) - left * (h * gamma * m + h * h * s.p);
  MatrixXd step(6, 6);
  step << MatrixXd::Identity(3, 3) + h * from_x, h * from_v, from_x, from_v;
  return step;
}

TEST(StabilityTheory, ImplicitLimitsAreWhereTheStepsMatrixGrows) {
  const System s;
  for (const double gamma : {0.0, 0.5, 5.0}) {
    const double h = hair::implicit_limit(s.mass, s.k, s.p, gamma);
    EXPECT_LE(spectral_radius(implicit_step(s, gamma, 0.999 * h)), 1 + 1e-7)
        << "gamma " << gamma << ", h " << h;
    EXPECT_GT(spectral_radius(implicit_step(s, gamma, 1.001 * h)), 1 + 1e-9)
        << "gamma " << gamma << ", h " << h;
    const double twice = hair::predictor_corrector_limit(s.mass, s.k, s.p, gamma, 1e3);
    ASSERT_TRUE(std::isfinite(twice)) << gamma;
    const auto step = [&](double at) { return hair::predictor_corrector_step(s.mass, s.k, s.p, gamma, at); };
    EXPECT_LE(spectral_radius(step(0.999 * twice)), 1 + 1e-7) << "H6, gamma " << gamma << ", h " << twice;
    EXPECT_GT(spectral_radius(step(1.001 * twice)), 1 + 1e-9) << "H6, gamma " << gamma << ", h " << twice;
    // The smallest limit of several modes: no error grows with any smaller step.
    for (int k = 1; k < 200; ++k)
      EXPECT_LE(spectral_radius(step(k / 200.0 * twice)), 1 + 1e-7)
          << "H6, gamma " << gamma << ", part " << k;
  }
  EXPECT_TRUE(std::isinf(hair::implicit_limit(s.mass, s.k, s.k, 0)));  // the whole derivative: none
}

}  // namespace
}  // namespace reference_tests
