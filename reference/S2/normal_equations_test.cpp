// STAFF ONLY. S2 with dependent columns, and its allocations: the public checks test the promises of
// solver/normal_equations.h. The normal equations lose as many digits as theory predicts.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/matrices.h"
#include "solver/normal_equations.h"
#include "solver/study/normal_digits.h"
#include "solver/test_allocations.h"
#include "solver/test_numbers.h"

namespace reference_tests {
namespace {

using Vector = std::vector<double>;

using namespace solver::study;

struct Normal {
  Vector x;
  double squared_residual;
};

Normal solve_normal(solver::SparseMatrix A, Vector b, double epsilon) {
  solver::SparseMatrix At = A.transposed();
  Vector x(A.cols(), kNaN);
  int steps = 0;
  const double rr = solve_normal_equations(A.rows(), A.cols(), &A, &At, x.data(), b.data(), epsilon, &steps);
  return {x, rr};
}

TEST(NormalMatrix, AllocatesNothingInAProduct) {
  solver::SparseMatrix A = solver::tridiagonal(1000, 2, -1);
  auto AtA = normal_matrix(1000, 1000, &A, &A);
  Vector x(1000, 1.0), b(1000);
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  AtA->matVecMult(x.data(), b.data());
  EXPECT_EQ(allocations(), before);
}

TEST(SolveNormalEquations, EndsWhereTheColumnsDepend) {
  const solver::SparseMatrix A(2, 3, {{0, 0, 1}, {0, 1, 1}, {1, 2, 1}});  // A'A is singular, A'b in its range
  const Normal s = solve_normal(A, {2, 5}, 1e-20);
  EXPECT_LE(s.squared_residual, 1e-20);
  EXPECT_NEAR(s.x[0] + s.x[1], 2, 1e-10);
  EXPECT_NEAR(s.x[2], 5, 1e-10);
  EXPECT_FALSE(solve_normal(A, {kNaN, 1}, 1e-5).squared_residual <= 1e-5);
  EXPECT_EQ(solve_normal(solver::SparseMatrix(2, 0, {}), {1, 2}, 0).squared_residual, 0);
  EXPECT_EQ(solve_normal(solver::SparseMatrix(0, 2, {}), {}, 0).x, (Vector{0, 0}));
}

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
