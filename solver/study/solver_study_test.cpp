// The study's own parts: properties of its systems, other solvers, and a wrong solver.
#include "solver/study/solver_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "solver/study/banded_cholesky.h"
#include "solver/study/bowl_path.h"
#include "solver/study/history.h"
#include "solver/study/systems.h"

namespace solver::study {
namespace {

double dot(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// True if sign (A - shift I) is positive definite: all of A's eigenvalues are above the shift, or below it.
bool definite(const SparseMatrix& A, double sign, double shift) {
  std::vector<SparseMatrix::Entry> entries = A.entries();
  for (SparseMatrix::Entry& entry : entries) entry.value *= sign;
  for (int i = 0; i < A.rows(); ++i) entries.push_back({i, i, -sign * shift});
  try {
    const BandedCholesky factored(SparseMatrix(A.rows(), A.cols(), entries));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// Rounding moves them by about u times the condition number, here below 1e5.
TEST(Systems, AStrandHasTheEigenvaluesThatItSays) {
  constexpr double kClose = 1e-9;
  for (const double step : {1e-5, 1e-4, 1e-3}) {
    const System system = strand_system(10, step);
    const SparseMatrix A = strand_matrix(10, step);
    EXPECT_TRUE(definite(A, 1, (1 - kClose) * system.smallest)) << step;
    EXPECT_FALSE(definite(A, 1, (1 + kClose) * system.smallest)) << step;
    EXPECT_TRUE(definite(A, -1, (1 + kClose) * system.largest)) << step;
    EXPECT_FALSE(definite(A, -1, (1 - kClose) * system.largest)) << step;
  }
}

TEST(Systems, TheSolutionSolvesThem) {
  for (const System& system : {spread_system(50, 1e4), clustered_system(50, 1e4, 3), strand_system(5, 1e-3)})
    EXPECT_EQ(product(*system.matrix, system.solution), system.right_side) << system.name;
  EXPECT_THROW(clustered_system(50, 1e4, 1), std::invalid_argument);
}

TEST(BandedCholeskyTest, SolvesAStrandAndRefusesWhatIsNotDefinite) {
  const SparseMatrix A = strand_matrix(30, 1e-2);
  const System system = strand_system(30, 1e-2);
  const BandedCholesky factored(A);
  EXPECT_EQ(factored.width(), 3);
  Vector x = system.right_side;
  factored.solve(x.data());
  // Higham, theorem 10.4, for a band of w = 3: ||b - Ax|| <= 4 (3w + 1) u || |L||L'| || ||x||, and |L||L'| is
  // at most w + 1 times as large as A.
  const double residual = std::sqrt(squared_norm(difference(system.right_side, product(*system.matrix, x))));
  EXPECT_LE(residual, 4 * 10 * 4 * kRounding * A.norm_bound() * std::sqrt(squared_norm(x)));
  EXPECT_THROW(BandedCholesky(tridiagonal(5, 1, -1)), std::invalid_argument)
      << "an eigenvalue is 1 - sqrt(3)";
  EXPECT_THROW(BandedCholesky(SparseMatrix(2, 3, {})), std::invalid_argument);
}

double eigen(int n, implicitMatrix* A, double x[], double b[], double, int* steps) {
  eigen_conj_grad(n, A, x, b, 0, steps);
  return 0;
}

// A wrong method that claims to be conjugate gradients: steepest descent.
double steepest_descent(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  Vector r(n), q(n);
  std::copy(b, b + n, x);
  const int most = *steps;
  double squared = 0;
  for (int k = 0;; ++k) {
    A->matVecMult(x, q.data());
    for (int i = 0; i < n; ++i) r[i] = b[i] - q[i];
    squared = squared_norm(r);
    *steps = k;
    if (k == most || squared <= epsilon) return squared;
    A->matVecMult(r.data(), q.data());
    const double alpha = squared / dot(r, q);
    for (int i = 0; i < n; ++i) x[i] += alpha * r[i];
  }
}

// The number of errors above the bound of conjugate gradients, before they come near rounding.
int violations(const History& history) {
  int count = 0;
  for (const Progress& one : history.progress)
    count += one.error > 1e-9 && one.error > error_bound(history.condition, one.iterations);
  return count;
}

TEST(HistoryTest, ConjugateGradientsStayBelowTheBoundAndSteepestDescentDoesNot) {
  for (const double condition : {10.0, 1e2, 1e3}) {
    const System system = spread_system(100, condition);
    EXPECT_EQ(violations(history_of(eigen, "Eigen", system, 2000, {})), 0) << condition;
    EXPECT_GT(violations(history_of(steepest_descent, "steepest descent", system, 2000, {})), 3) << condition;
  }
}

// Like ConjGrad, which takes a negative number for no step.
ConjGradFunction with_none(const ConjGradFunction& solve) {
  return [=](int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
    if (*steps >= 0) return solve(n, A, x, b, epsilon, steps);
    std::copy(b, b + n, x);
    *steps = 0;
    return 0.0;
  };
}

TEST(BowlPathTest, TwoUnknownsTakeTwoStepsAndDescentZigzags) {
  const BowlPath right = symmetric_path(with_none(eigen)),
                 zigzag = symmetric_path(with_none(steepest_descent));
  EXPECT_EQ(right.steps_to_bottom(), 2);
  EXPECT_EQ(zigzag.steps_to_bottom(), std::nullopt);
  EXPECT_NEAR(zigzag.height(zigzag.places[1]), right.height(right.places[1]), 1e-12)
      << "the first step is the same";
  for (std::size_t k = 1; k < zigzag.places.size(); ++k)
    EXPECT_LT(zigzag.height(zigzag.places[k]), zigzag.height(zigzag.places[k - 1])) << k;
  EXPECT_GT(zigzag.height(zigzag.places.back()), 0.01) << "one sees it";
}

TEST(BowlPathTest, TheNormalEquationsHaveTheSquareOfTheConditionNumber) {
  const auto squares = [](int, int, implicitMatrix* A, implicitMatrix* At, double x[], double b[], double,
                          int* steps) {
    Vector right_side(2);
    At->matVecMult(b, right_side.data());
    std::copy(right_side.begin(), right_side.end(), x);
    Vector forward(2), back(2);
    A->matVecMult(x, forward.data());
    At->matVecMult(forward.data(), back.data());
    *steps = 0;
    return squared_norm(difference(right_side, back));
  };
  const BowlPath path = normal_path(squares);
  EXPECT_NEAR(path.height(path.places[0]), 1, 1e-12) << "A'b is the first guess";
  EXPECT_EQ(path.bottom, symmetric_path(eigen).bottom);
  // Trace and determinant of C: the sum and the product of kSingular^2 and its inverse.
  EXPECT_NEAR(path.xx + path.yy, kSingular * kSingular + 1 / (kSingular * kSingular), 1e-12);
  EXPECT_NEAR(path.xx * path.yy - path.xy * path.xy, 1, 1e-12);
  EXPECT_EQ(path.condition, std::pow(symmetric_path(eigen).condition, 2));
}

TEST(HistoryTest, AnInterruptionEndsTheStudyAndNoNumberEndsAHistory) {
  const std::atomic<bool> interrupted = true;
  EXPECT_FALSE(study_solvers({eigen, {}}, {true}, interrupted, [](const std::string&) {}));
  const auto broken = [](int n, implicitMatrix*, double x[], double[], double, int*) {
    std::fill(x, x + n, std::nan(""));
    return std::nan("");
  };
  EXPECT_EQ(history_of(broken, "broken", spread_system(10, 10), 100, {}).progress.size(), 1);
}

double honest(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  eigen_conj_grad(n, A, x, b, std::sqrt(epsilon / squared_norm(Vector(b, b + n))), steps);
  return epsilon;
}

TEST(IterationsNeededTest, AreOnlyThoseThatLedThere) {
  const System system = spread_system(100, 1e3);
  const std::optional<int> needed = iterations_needed(honest, system, 1000);
  ASSERT_TRUE(needed);
  EXPECT_GT(*needed, 20);
  EXPECT_LE(*needed, needed_at_most(1e3));
  EXPECT_EQ(iterations_needed(honest, system, *needed), needed) << "exactly as many as allowed";
  EXPECT_EQ(iterations_needed(honest, system, *needed - 2), std::nullopt);

  const auto breaks_off = [](int n, implicitMatrix* A, double x[], double b[], double, int* steps) {
    *steps = 1;
    return honest(n, A, x, b, 0, steps);
  };
  EXPECT_EQ(iterations_needed(breaks_off, system, 1000), std::nullopt);
  const auto does_not_count = [](int n, implicitMatrix* A, double x[], double b[], double epsilon,
                                 int* steps) {
    const double squared = honest(n, A, x, b, epsilon, steps);
    *steps = 1;
    return squared;
  };
  EXPECT_EQ(iterations_needed(does_not_count, system, 1000), std::nullopt);
  const auto no_numbers = [](int n, implicitMatrix*, double x[], double[], double, int* steps) {
    std::fill(x, x + n, std::nan(""));
    *steps = 5;
    return 0.0;
  };
  EXPECT_EQ(iterations_needed(no_numbers, system, 1000), std::nullopt);
}

// Compared calls are timed in turn: a temporary slowdown of the machine affects all of them.
TEST(HistoryTest, OtherCallsAreTimedInTurnWithTheIterations) {
  const System system = spread_system(10, 10);
  std::string order;
  const ConjGradFunction solve = [&](int, implicitMatrix*, double[], double[], double, int* steps) {
    order += std::to_string(*steps);
    return 0.0;
  };
  History history;
  history.progress.resize(2);
  history.progress[0].asked = 1;
  history.progress[1].asked = 2;
  double seconds = -1;
  time_in_turn(system, {{&solve, &history}}, {{[&] { order += "D"; }, &seconds}}, {0, 9}, {});
  EXPECT_EQ(order, "D12D12D12D12") << "the first warm up, and long calls are repeated less";
  EXPECT_GE(seconds, 0);
}

TEST(EigenConjGradTest, CountsIterationsFromNone) {
  const auto steps = [](double first, double second, Vector b) {
    SparseMatrix A(2, 2, {{0, 0, first}, {1, 1, second}});
    Vector x(2);
    int taken = 10;
    eigen_conj_grad(2, &A, x.data(), b.data(), 1e-8, &taken);
    return taken;
  };
  EXPECT_EQ(steps(1, 1, {3, 4}), 0) << "the first guess is the solution";
  EXPECT_EQ(steps(2, 2, {3, 4}), 1);
  EXPECT_EQ(steps(1, 2, {3, 4}), 1) << "the first residual is an eigenvector";
  EXPECT_EQ(steps(4, 2, {3, 4}), 2);
  EXPECT_EQ(steps(4, 2, {0, 0}), 0);
}

// It ends at once, so that a study is short.
double does_nothing(int n, implicitMatrix*, double x[], double b[], double, int* steps) {
  std::copy(b, b + n, x);
  *steps = 0;
  return 0;
}

TEST(SolverStudyTest, WithoutNormalEquationsAllFamiliesAreMeasuredAndTimedBesideOthers) {
  const std::atomic<bool> interrupted = false;
  const auto no_normal = [](int, int, implicitMatrix*, implicitMatrix*, double[], double[], double,
                            int*) -> double { throw NotImplemented("S2 solve_normal_equations"); };
  const auto study = study_solvers({does_nothing, no_normal}, {true}, interrupted, [](const std::string&) {});
  ASSERT_TRUE(study);
  ASSERT_TRUE(study->not_written);
  EXPECT_STREQ(study->not_written->what(), "S2 solve_normal_equations is not implemented yet");
  EXPECT_TRUE(study->digits.empty());
  for (const std::vector<Compared>* family : {&study->conditions, &study->strands}) {
    EXPECT_GE(family->size(), 4);
    for (const Compared& on : *family) {
      EXPECT_EQ(on.direct.has_value(), family == &study->strands) << "full matrices have no band";
      EXPECT_EQ(on.conj_grad.system, on.eigen.system);
      for (const History* history : on.histories())
        for (const Progress& one : history->progress)
          EXPECT_GT(one.seconds, 0) << history->system << ", " << history->solver;
      if (on.direct) {
        EXPECT_GT(on.direct->factor_seconds, 0);
        EXPECT_GT(on.direct->solve_seconds, 0);
      }
    }
  }
}

}  // namespace
}  // namespace solver::study
