// STAFF ONLY. What ConjGrad promises where Ax = b can be solved: one test for each sentence of its contract.

#include <gtest/gtest.h>

#include <cstring>

#include "reference/tests/solve.h"
#include "solver/matrices.h"

namespace reference_tests {
namespace {

bool same_bits(const Vector& x, const Vector& y) {
  return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), 8 * x.size()) == 0);
}

solver::SpectralMatrix spectral(const Vector& spectrum) {
  const int n = static_cast<int>(spectrum.size());
  return {spectrum, {scattered(n, 11), scattered(n, 12), scattered(n, 13)}};
}

// A strand of 40 hairs' worth of masses and stiff springs: 120 unknowns, condition number about 1e5.
solver::SparseMatrix strand() {
  return solver::strand_implicit_euler(Vector(40, 1e-8), 100, 0.01, 1e-3);
}

TEST(ConjGrad, SolvesTheLecturesExamples) {
  Matrix A1([](const double* x, double* b) { b[0] = 2 * x[0], b[1] = x[1]; });
  const Solution one = solve(A1, {1, 1}, 1e-5, 100);
  EXPECT_EQ(one.steps, 1);
  EXPECT_EQ(one.squared_residual, 0);
  EXPECT_EQ(one.x, (Vector{0.5, 1}));

  Matrix A2([](const double* x, double* b) { b[0] = 2 * x[0] + x[1], b[1] = x[0] + x[1]; });
  const Solution two = solve(A2, {3, 4}, 1e-5, 100);
  EXPECT_EQ(two.steps, 2);
  // cond(A2) = 6.9; two steps of rounding, each of a few u, move x by no more than that times as much
  EXPECT_NEAR(two.x[0], -1, 100 * 6.9 * kUnit);
  EXPECT_NEAR(two.x[1], 5, 100 * 6.9 * kUnit);
}

TEST(ConjGrad, TakesNoStepWhereTheFirstGuessIsRight) {
  solver::SparseMatrix identity = solver::diagonal(Vector(5, 1.0));
  const Solution same = solve(identity, scattered(5), 0, 0);
  EXPECT_EQ(same.steps, 0);
  EXPECT_EQ(same.squared_residual, 0);
  EXPECT_EQ(same.x, scattered(5));
  EXPECT_EQ(same.products, 1);

  solver::SparseMatrix A = solver::tridiagonal(5, 2, -1);
  const Solution zero = solve(A, Vector(5, 0.0), 0, 0);
  EXPECT_EQ(zero.steps, 0);
  EXPECT_EQ(zero.squared_residual, 0);
  EXPECT_EQ(zero.x, Vector(5, 0.0));

  int steps = 7;
  EXPECT_EQ(ConjGrad(0, &A, nullptr, nullptr, -1, &steps), 0);
  EXPECT_EQ(steps, 0);
}

TEST(ConjGrad, SolvesEverySizeAroundItsUnrolledLoops) {
  for (int n = 1; n <= 40; ++n) {
    solver::SparseMatrix A = solver::tridiagonal(n, 4, -1);  // eigenvalues in (2, 6)
    Vector x = scattered(n), b(n);
    A.matVecMult(x.data(), b.data());
    const Solution s = solve(A, b, 1e-24, 0);
    EXPECT_LE(s.squared_residual, 1e-24) << n;
    // ||x - x*|| <= ||A^-1|| (||r|| + the drift of r), ||A^-1|| < 1/2
    const double drift = 64 * 16 * kUnit * 6 * (2 * norm(x) + norm(b));
    EXPECT_LE(norm(difference(s.x, x)), (1e-12 + drift) / 2) << n;
  }
}

TEST(ConjGrad, ShrinksTheErrorAsTheConditionNumberPromises) {
  // ||e_k||_A <= 2 ((sqrt(c) - 1) / (sqrt(c) + 1))^k ||e_0||_A (Golub and Van Loan, theorem 11.3.3), c =
  // cond(A).
  const int n = 200;
  for (double c : {10.0, 100.0, 1000.0}) {
    solver::SpectralMatrix A = spectral(solver::log_spaced(n, 1 / c, 1));
    Vector exact = scattered(n), b(n);
    A.matVecMult(exact.data(), b.data());
    auto energy = [&](const Vector& x) {
      Vector e = difference(x, exact), Ae(n);
      A.matVecMult(e.data(), Ae.data());
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += e[i] * Ae[i];
      return std::sqrt(sum);
    };
    for (int k : {5, 10, 20, 40}) {
      const double factor = 2 * std::pow((std::sqrt(c) - 1) / (std::sqrt(c) + 1), k);
      if (factor < 1e-10) continue;  // where rounding rules
      EXPECT_LE(energy(solve(A, b, 0, k).x), factor * energy(b)) << "cond " << c << ", step " << k;
    }
  }
}

TEST(ConjGrad, NeedsOneStepForEachDistinctEigenvalue) {
  for (int distinct : {1, 2, 3, 5}) {
    Vector spectrum(60);
    for (int i = 0; i < 60; ++i) spectrum[i] = 2 + i % distinct;
    solver::SpectralMatrix A = spectral(spectrum);
    // In exact arithmetic the residual is 0 then; rounding leaves the products' e u ||A|| ||x||, e about 7
    // * 60.
    const double epsilon = std::pow(64 * 420 * kUnit * 6 * 60, 2);
    EXPECT_EQ(solve(A, scattered(60), epsilon, 0).steps, distinct);
  }
}

TEST(ConjGrad, DoesNotCareWhatWasInX) {
  solver::SparseMatrix A = strand();
  const Solution s = solve(A, scattered(120), 1e-20, 0);
  for (double junk : {0.0, 1e300, kNaN, -kInf})
    EXPECT_TRUE(same_bits(solve(A, scattered(120), 1e-20, 0, junk).x, s.x));
}

TEST(ConjGrad, LeavesBAlone) {
  solver::SparseMatrix A = strand();
  EXPECT_TRUE(same_bits(solve(A, scattered(120), 1e-20, 0).b, scattered(120)));
}

TEST(ConjGrad, KeepsNoState) {
  solver::SparseMatrix A = strand(), other = solver::poisson_2d(9);
  const Solution first = solve(A, scattered(120), 1e-20, 0);
  solve(other, scattered(81), 1e-20, 7);
  const Solution again = solve(A, scattered(120), 1e-20, 0);
  EXPECT_TRUE(same_bits(first.x, again.x));
  EXPECT_EQ(first.squared_residual, again.squared_residual);
  EXPECT_EQ(first.steps, again.steps);
}

TEST(ConjGrad, EndsAsSoonAsTheSquaredResidualIsEpsilon) {
  solver::SparseMatrix A = solver::poisson_2d(20);
  double smallest = kInf;
  for (int k = 0; k <= 70; ++k) {
    const double rr = solve(A, scattered(400), -1, k == 0 ? -1 : k).squared_residual;
    if (rr < smallest) {  // no earlier residual was as small
      EXPECT_EQ(solve(A, scattered(400), rr, 0).steps, k);
      EXPECT_GT(solve(A, scattered(400), std::nextafter(rr, 0), 0).steps, k);
    }
    smallest = std::min(smallest, rr);
  }
}

TEST(ConjGrad, TakesTheStepsAllowed) {
  for (int n : {10, 50, 51, 90}) {
    solver::SpectralMatrix A = spectral(solver::log_spaced(n, 1e-12, 1));
    EXPECT_EQ(solve(A, scattered(n), -1, 0).steps, std::max(100, 2 * n))
        << "0 stands for max(100, 2n), n = " << n;
    EXPECT_EQ(solve(A, scattered(n), -1, 1).steps, 1);
    EXPECT_EQ(solve(A, scattered(n), -1, 77).steps, 77);
  }
  solver::SparseMatrix A = solver::tridiagonal(4, 2, -1);
  const Solution none = solve(A, {1, 2, 3, 5}, 0, -3);
  EXPECT_EQ(none.steps, 0);
  EXPECT_EQ(none.x, (Vector{1, 2, 3, 5}));
  EXPECT_EQ(none.squared_residual, 25) << "||b - Ab||^2, b - Ab = (1, 2, 4, -2)";
}

TEST(ConjGrad, CountsItsProducts) {
  solver::SpectralMatrix A = spectral(solver::log_spaced(100, 1e-9, 1));
  for (int k : {-1, 1, 2, 62, 63, 64, 65, 127, 128, 129}) {
    const Solution s = solve(A, scattered(100), -1, k);
    EXPECT_EQ(s.products, 1 + s.steps + s.steps / 64) << s.steps << " steps";
  }
  // The 64th takes its second product even if it is the last because epsilon is reached.
  const double reached = solve(A, scattered(100), -1, 64).squared_residual;
  const Solution s = solve(A, scattered(100), reached, 0);
  EXPECT_LE(s.steps, 64);
  EXPECT_EQ(s.products, 1 + s.steps + s.steps / 64);
}

// ||b - Ax||, the product in the working precision: e u ||A|| ||x|| off.
double true_residual(implicitMatrix& A, Vector x, const Vector& b) {
  Vector Ax(b.size());
  A.matVecMult(x.data(), Ax.data());
  return norm(difference(b, Ax));
}

TEST(ConjGrad, ReturnsTheTrueResidualEachSixtyFourthStep) {
  const int n = 100;
  solver::SpectralMatrix A = spectral(solver::log_spaced(n, 1e-10, 1));
  for (int k : {64, 128, 192}) {
    const Solution s = solve(A, scattered(n), -1, k);
    const double truth = true_residual(A, s.x, scattered(n));
    EXPECT_NEAR(std::sqrt(s.squared_residual), truth, n * kUnit * truth) << "step " << k;
  }
  const Solution s = solve(A, scattered(n), -1, 63);
  const double truth = true_residual(A, s.x, scattered(n));
  EXPECT_GT(std::abs(std::sqrt(s.squared_residual) - truth), n * kUnit * truth)
      << "no drift: the test shows nothing";
}

TEST(ConjGrad, DriftsNoFurtherThanItsContractSays) {
  auto check = [](implicitMatrix& A, int n, double norm_of_A, double e, const Vector& exact,
                  const char* name) {
    Vector x = exact, b(n);
    A.matVecMult(x.data(), b.data());
    for (int k : {1, 10, 63, 64, 100, 127, 500}) {
      const Solution s = solve(A, b, 0, k);
      const double returned = std::sqrt(s.squared_residual), truth = true_residual(A, s.x, b);
      const double bound =
          64 * (10 + 2 * e) * kUnit * norm_of_A * (2 * norm(exact) + norm(b)) + n * kUnit * returned;
      EXPECT_LE(std::abs(returned - truth), bound) << name << ", step " << s.steps;
    }
  };
  for (solver::SparseMatrix A :
       {strand(), solver::poisson_2d(20), solver::hilbert(10), solver::tridiagonal(1000, 2, -1)})
    check(A, A.rows(), A.norm_bound(), A.longest_row(), scattered(A.rows()), "sparse");
  solver::SpectralMatrix A = spectral(solver::log_spaced(200, 1e-12, 1));
  check(A, 200, 1, 7 * 200, scattered(200), "spectral");
}

TEST(ConjGrad, ScalesByPowersOfTwoBitByBit) {
  solver::SparseMatrix poisson = solver::poisson_2d(15), hair = strand();
  for (solver::SparseMatrix* A : {&poisson, &hair}) {
    const Vector b = scattered(A->rows());
    const Solution s = solve(*A, b, 1e-16, 0);
    ASSERT_GT(s.steps, 20);
    for (int k : {-465, -300, -1, 1, 300, 465}) {
      Vector scaled = b, expected = s.x;
      for (double& v : scaled) v = std::ldexp(v, k);
      for (double& v : expected) v = std::ldexp(v, k);
      const Solution t = solve(*A, scaled, std::ldexp(1e-16, 2 * k), 0);
      EXPECT_EQ(t.steps, s.steps) << "2^" << k;
      EXPECT_TRUE(same_bits(t.x, expected)) << "2^" << k;
      EXPECT_EQ(t.squared_residual, std::ldexp(s.squared_residual, 2 * k)) << "2^" << k;
    }
  }
}

}  // namespace
}  // namespace reference_tests
