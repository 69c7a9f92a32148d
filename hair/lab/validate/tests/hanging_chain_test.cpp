// The theory of hanging chains against its own equations.
#include "hair/lab/validate/hanging_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/test_numbers.h"

namespace hair {
namespace {

using reference_tests::kUnit;

// The residual of m_i x q_i = T_i (q_i - q_{i-1}) / g - T_{i+1} (q_{i+1} - q_i) / g, over the largest of all
// terms.
double largest_residual(const HangingChain& chain, double x) {
  const Eigen::VectorXd angles = mode_angles(chain, x);
  double residual = 0, term = 0, sideways = 0;
  for (int i = 0; i < chain.count(); ++i) {
    sideways += angles[i];
    const double above = chain.tension(i) / chain.gravity * angles[i];
    const double below = i + 1 < chain.count() ? chain.tension(i + 1) / chain.gravity * angles[i + 1] : 0.0;
    const double inertia = chain.mass[i] * x * sideways;
    residual = std::max(residual, std::abs(inertia + below - above));
    term = std::max({term, std::abs(inertia), std::abs(above)});
  }
  return residual / term;
}

// The sums over masses, here and in mode_angles, round n times, each by 2^-53 of the largest of n terms. x
// itself has a rounding error of 2^-53, and the sideways positions of n masses add it up. A heavy lower mass
// multiplies the rounding error of its own position, which is small if the links above it turn both ways.
TEST(HangingChain, ModesSatisfyTheirEquations) {
  for (const int n : {1, 2, 10, 20}) {
    const HangingChain chain{Eigen::VectorXd::Constant(n, 1e-7)};
    for (const double x : laguerre_zeros(n))
      EXPECT_LE(largest_residual(chain, x), 10 * n * n * kUnit) << n << " masses, x = " << x;
  }
  for (const double ratio : {1e-4, 1.0, 1e6}) {
    const HangingChain chain{Eigen::Vector2d(1e-7, ratio * 1e-7)};
    for (const double x : double_pendulum_squares(ratio))
      EXPECT_LE(largest_residual(chain, x), 40 * (1 + ratio) * kUnit) << "ratio " << ratio << ", x = " << x;
  }
}

// sum x_k = n^2 and sum 1/x_k = n: the coefficients of L_n.
TEST(HangingChain, LaguerreZerosHaveTheSumsThatCoefficientsGive) {
  for (const int n : {1, 2, 5, 10, 20, 40}) {
    const Eigen::VectorXd zeros = laguerre_zeros(n);
    EXPECT_NEAR(zeros.sum(), n * n, 1e3 * n * n * kUnit) << n;
    EXPECT_NEAR(zeros.cwiseInverse().sum(), n, 1e3 * n * n * kUnit) << n;
  }
}

TEST(HangingChain, TwoEqualMassesAreBothAChainAndADoublePendulum) {
  const Eigen::VectorXd zeros = laguerre_zeros(2);
  const Eigen::Vector2d squares = double_pendulum_squares(1);
  EXPECT_NEAR(zeros[0], squares[0], 16 * kUnit);
  EXPECT_NEAR(zeros[1], squares[1], 16 * kUnit);
}

// w^2 = (g/l) (1 + mu +- sqrt(mu (1 + mu))), the slow one without the difference's cancellation: their
// product is 1 + mu.
TEST(HangingChain, DoublePendulumsSatisfyTheirQuadraticEquation) {
  for (const double ratio : {1e-6, 1e-2, 1.0, 1e2, 1e6}) {
    const Eigen::Vector2d x = double_pendulum_squares(ratio);
    EXPECT_NEAR(x[0] * x[1] / (1 + ratio), 1, 16 * kUnit) << ratio;
    EXPECT_NEAR(x.sum() / (2 * (1 + ratio)), 1, 16 * kUnit) << ratio;
  }
}

TEST(HangingChain, OnePendulumSlowsByASixteenthOfItsAngleSquared) {
  const HangingChain chain{Eigen::VectorXd::Constant(1, 1e-7)};
  EXPECT_NEAR(softening(chain, 1, mode_angles(chain, 1)), -1.0 / 16, 4 * kUnit);
}

}  // namespace
}  // namespace hair
