// STAFF ONLY. The normal equations lose as many digits as theory predicts.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/normal_equations.h"
#include "solver/study/normal_digits.h"

namespace reference_tests {
namespace {

using namespace solver::study;

// The slope of the errors' logarithm while the condition number grows by a factor of 10^decades.
double slope(double first, double last, int decades) {
  return std::log10(last / first) / decades;
}

TEST(SolverTheory, QrLosesADigitWhereTheNormalEquationsLoseTwo) {
  constexpr int n = kDigitsUnknowns;
  const auto at = [](double condition) { return digits_lost(solve_normal_equations, condition, 9, 4000); };
  const DigitsLost low = at(1e2), high = at(1e5);
  for (const DigitsLost& one : {low, high}) {
    // Higham, theorems 19.5 (QR; its small constant as 6) and 10.4 (Cholesky), to first order.
    const double qr = 6.0 * n * n * std::sqrt(n) * kRounding * one.condition;
    const double normal = 4.0 * n * (3 * n + 1) * kRounding * one.condition * one.condition;
    EXPECT_LE(one.qr, qr) << "condition " << one.condition;
    EXPECT_LE(one.cholesky, normal) << "condition " << one.condition;
    EXPECT_LE(one.conj_grad, normal) << "condition " << one.condition;
  }
  // Over three decades constants that differ by 10 change the slope by a third, which tells one digit from
  // two.
  const double tolerance = 1.0 / 3;
  EXPECT_NEAR(slope(low.qr, high.qr, 3), 1, tolerance);
  EXPECT_NEAR(slope(low.cholesky, high.cholesky, 3), 2, tolerance);
  EXPECT_NEAR(slope(low.conj_grad, high.conj_grad, 3), 2, tolerance);
  EXPECT_TRUE(std::isnan(at(1e12).cholesky)) << "A'A is singular to rounding beyond a condition of 1e8";
  EXPECT_FALSE(high.stopped) << high.iterations << " iterations";
  EXPECT_TRUE(digits_lost(solve_normal_equations, 1e5, 1, high.iterations / 2).stopped);
}

}  // namespace
}  // namespace reference_tests
