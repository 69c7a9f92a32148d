// STAFF ONLY. The solver's study measures ConjGrad and the normal equations as theory predicts.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/normal_equations.h"
#include "solver/study/solver_study.h"
#include "solver/study/systems.h"

namespace reference_tests {
namespace {

using namespace solver::study;

// The error in the A-norm that rounding leaves, from the bound on the residual in linearSolver.h: ||e||_A <=
// ||r|| / sqrt(smallest eigenvalue). A product with two reflections on either side is rounded by 4 (n + 4) u.
double rounding_floor(const System& system) {
  const double X = 2 * std::sqrt(squared_norm(system.solution)) + std::sqrt(squared_norm(system.right_side));
  const double residual = 64 * (10 + 2 * 4 * (system.n() + 4)) * kRounding * system.largest * X;
  const double first = energy_norm(*system.matrix, difference(system.right_side, system.solution));
  return residual / std::sqrt(system.smallest) / first;
}

History history(const System& system, int most = 20000) {
  return history_of(ConjGrad, "ConjGrad", system, most, {});
}

TEST(SolverTheory, TheErrorInTheANormIsBelowTheBoundOfConjugateGradients) {
  for (const double condition : {1e1, 1e2, 1e3, 1e4, 1e6}) {
    const System system = spread_system(200, condition);
    const double floor = rounding_floor(system);
    const History measured = history(system);
    EXPECT_LT(measured.progress.back().error, floor) << "condition " << condition;
    for (const Progress& one : measured.progress)
      EXPECT_LE(one.error, error_bound(condition, one.iterations) + floor)
          << "condition " << condition << ", " << one.iterations << " iterations";
  }
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

TEST(SolverTheory, AQuickStudyNeedsNoMoreIterationsThanTheoryAllows) {
  const std::atomic<bool> interrupted = false;
  const auto study =
      study_solvers({ConjGrad, solve_normal_equations}, {true}, interrupted, [](const std::string&) {});
  ASSERT_TRUE(study);
  for (const IterationsNeeded& one : study->needed) {
    ASSERT_TRUE(one.conj_grad) << one.condition;
    EXPECT_LE(*one.conj_grad, one.bound) << one.condition;
    EXPECT_LE(one.eigen.value_or(0), one.bound) << one.condition;
    EXPECT_LE(one.clustered.value_or(1000), 2 * kNeededClusters) << one.condition;
    EXPECT_LE(one.normal_equations.value_or(0), needed_at_most(one.condition * one.condition));
  }
  for (const Compared& on : study->strands) {
    ASSERT_TRUE(on.direct);
    EXPECT_LT(on.direct->error, 1e-12) << on.direct->system;
  }
  EXPECT_EQ(study->digits.size(), 8);
}

}  // namespace
}  // namespace reference_tests
