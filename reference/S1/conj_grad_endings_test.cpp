// STAFF ONLY. If Ax = b can't be solved, ConjGrad ends at once, with the last finite x and an honest
// residual.

#include <gtest/gtest.h>

#include "reference/S1/solve_for_tests.h"
#include "solver/matrices.h"

namespace reference_tests {
namespace {

// The residual is above epsilon: a number, an infinity or a NaN.
void expect_failure(const Solution& s, double epsilon) {
  EXPECT_FALSE(s.squared_residual <= epsilon);
}

TEST(ConjGradEnds, InALaterStepWithTheXOfTheStepBefore) {
  solver::SparseMatrix A = solver::diagonal({1, 2, 3, 4, 5, 6, 7, -0.1});
  const Vector b(8, 1.0);
  const Solution s = solve(A, b, 1e-20, 0);
  ASSERT_GT(s.steps, 1);
  const Solution before = solve(A, b, 1e-20, s.steps - 1);
  EXPECT_EQ(before.steps, s.steps - 1);
  EXPECT_EQ(s.x, before.x);
  EXPECT_EQ(s.squared_residual, before.squared_residual);
  expect_failure(s, 1e-20);
}

TEST(ConjGradEnds, AtAnythingNotFiniteThatAProductHolds) {
  const int n = 50;
  solver::SpectralMatrix A(solver::log_spaced(n, 1e-10, 1), {scattered(n, 2), scattered(n, 3)});
  const Vector b = scattered(n);
  for (double value : {kNaN, kInf, -kInf})
    for (int product : {2, 3, 10, 64, 65, 66, 67, 90})
      for (int at : {0, 7, n - 1}) {
        const std::string what = std::to_string(value) + " in product " + std::to_string(product);
        Watched spoilt(A, product, value, at);
        const Solution s = solve(spoilt, b, 1e-30, 0);
        EXPECT_EQ(s.products, product) << what << ": it ends at once";
        EXPECT_TRUE(all_finite(s.x)) << what;
        expect_failure(s, 1e-30);
        // Product 1 is the first residual's, 66 that of the x that step 64 has made.
        const int step = product <= 65 ? product - 1 : product - 2;
        EXPECT_EQ(s.steps, step) << what;
        const int last = product == 66 ? 64 : step - 1;
        EXPECT_EQ(s.x, solve(A, b, 1e-30, last == 0 ? -1 : last).x) << what;
        if (product == 66) {
          EXPECT_FALSE(std::isfinite(s.squared_residual)) << what << ": that x's residual";
        }
      }
}

TEST(ConjGradEnds, BeforeTheFirstStepIfTheFirstResidualIsNotFinite) {
  solver::SparseMatrix A = solver::tridiagonal(9, 2, -1);
  Watched spoilt(A, 1);
  const Solution s = solve(spoilt, Vector(9, 1.0), 1e10, 0);
  EXPECT_EQ(s.steps, 0);
  EXPECT_EQ(s.products, 1);
  EXPECT_EQ(s.x, Vector(9, 1.0));
  expect_failure(s, 1e10);
  for (double bad : {kNaN, kInf, -kInf, 1e200}) {  // 1e200 squared is more than a double holds
    Vector b(9, 1.0);
    b[4] = bad;
    const Solution t = solve(A, b, 1e10, 0);
    EXPECT_EQ(t.steps, 0) << bad;
    expect_failure(t, 1e10);
  }
}

TEST(ConjGradEnds, BeforeALargeFirstGuessOverflows) {
  // 1e-295 times ((2, -1), (-1, 1)), but for the first product, which leaves the residual (0, 1). Step 2
  // would add 1e295 to the largest number there is.
  const double largest = std::numeric_limits<double>::max(), a = 1e-295;
  bool first = true;
  Matrix A([&](const double* x, double* b) {
    b[0] = first ? largest : a * (2 * x[0] - x[1]);
    b[1] = first ? 0 : a * (x[1] - x[0]);
    first = false;
  });
  const Solution s = solve(A, {largest, 1}, 1e-5, 0);
  EXPECT_EQ(s.steps, 2);
  EXPECT_EQ(s.x[0], largest);
  EXPECT_NEAR(s.x[1] / 1e295, 1, 8 * kUnit);
}

TEST(ConjGradEnds, ForEveryEpsilon) {
  solver::SparseMatrix A = solver::poisson_2d(6);
  const Vector b = scattered(36);
  EXPECT_EQ(solve(A, b, kInf, 0).steps, 0);
  EXPECT_EQ(solve(A, b, 1e10, 0).steps, 0);
  for (double epsilon : {0.0, -1.0, 1e-320, kNaN}) {
    const Solution s = solve(A, b, epsilon, 0);
    EXPECT_LE(s.steps, 100) << epsilon;
    EXPECT_TRUE(all_finite(s.x)) << epsilon;
  }
}

TEST(ConjGradEnds, ForSingularSystems) {
  // The path graph's Laplacian: A 1 = 0. A b that is orthogonal to 1 can be solved, any other can't.
  const int n = 30;
  Matrix A([](const double* x, double* b) {
    for (int i = 0; i < n; ++i) b[i] = (i > 0 ? x[i] - x[i - 1] : 0) + (i + 1 < n ? x[i] - x[i + 1] : 0);
  });
  Vector consistent(n, 0.0), inconsistent(n, 1.0);
  consistent[3] = 1, consistent[20] = -1;
  inconsistent[4] = 2;
  EXPECT_LE(solve(A, consistent, 1e-20, 0).squared_residual, 1e-20);
  const Solution s = solve(A, inconsistent, 1e-20, 0);
  EXPECT_LE(s.steps, 100);
  EXPECT_TRUE(all_finite(s.x));
  expect_failure(s, 1e-20);
}

}  // namespace
}  // namespace reference_tests
