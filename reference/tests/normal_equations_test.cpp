// STAFF ONLY. What solver/normal_equations.h promises, sentence by sentence.

#include "solver/normal_equations.h"

#include <gtest/gtest.h>

#include "reference/tests/solve.h"
#include "solver/matrices.h"
#include "solver/tests/allocations.h"

namespace reference_tests {
namespace {

Vector product(implicitMatrix& A, Vector x, int rows) {
  Vector b(rows, kNaN);
  A.matVecMult(x.data(), b.data());
  return b;
}

struct Normal {
  Vector x;
  double squared_residual;
  int steps, products, transposed_products;
  Vector b;
};

Normal solve_normal(solver::SparseMatrix A, Vector b, double epsilon, int steps, double junk = kNaN) {
  solver::SparseMatrix At = A.transposed();
  Watched watched(A), watched_transposed(At);
  Vector x(A.cols(), junk);
  const double rr = solve_normal_equations(A.rows(), A.cols(), &watched, &watched_transposed, x.data(),
                                           b.data(), epsilon, &steps);
  return {x, rr, steps, watched.products, watched_transposed.products, b};
}

TEST(DenseMatrix, IsTheTableByRows) {
  const Vector table = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(product(*dense_matrix(2, 3, table.data()), {1, 10, 100}, 2), (Vector{321, 654}));
  EXPECT_EQ(product(*dense_matrix(3, 2, table.data()), {1, 10}, 3), (Vector{21, 43, 65}));
  EXPECT_EQ(product(*dense_matrix(1, 1, table.data()), {7}, 1), (Vector{7}));
}

TEST(DenseMatrix, OwnsItsTable) {
  Vector table = {2, 0, 0, 3};
  auto A = dense_matrix(2, 2, table.data());
  table.assign(4, kNaN);
  EXPECT_EQ(product(*A, {1, 1}, 2), (Vector{2, 3}));
}

TEST(DenseMatrix, MayBeEmpty) {
  EXPECT_EQ(product(*dense_matrix(0, 0, nullptr), {}, 0), Vector{});
  EXPECT_EQ(product(*dense_matrix(2, 0, nullptr), {}, 2), (Vector{0, 0})) << "a sum of no terms";
  EXPECT_EQ(product(*dense_matrix(0, 2, nullptr), {1, 2}, 0), Vector{});
}

TEST(NormalMatrix, IsTheTransposeTimesTheMatrix) {
  solver::SparseMatrix A(3, 2, {{0, 0, 1}, {0, 1, 2}, {1, 0, 3}, {1, 1, 4}, {2, 0, 5}, {2, 1, 6}});
  solver::SparseMatrix At = A.transposed();
  Watched watched(A), watched_transposed(At);
  auto AtA = normal_matrix(3, 2, &watched, &watched_transposed);
  EXPECT_EQ(product(*AtA, {1, 0}, 2), (Vector{35, 44}));
  EXPECT_EQ(product(*AtA, {0, 1}, 2), (Vector{44, 56}));
  EXPECT_EQ(watched.products, 2);
  EXPECT_EQ(watched_transposed.products, 2);
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

TEST(SolveNormalEquations, SolvesWhatIsNotSymmetricOrNotDefinite) {
  const solver::SparseMatrix rotation(2, 2, {{0, 1, -1}, {1, 0, 1}});  // x'Ax = 0 for all x
  EXPECT_EQ(solve_normal(rotation, {3, 4}, 1e-20, 0).x, (Vector{4, -3}));

  const solver::SparseMatrix indefinite(
      2, 2, {{0, 0, 1}, {0, 1, 2}, {1, 0, 2}, {1, 1, 1}});  // eigenvalues 3 and -1
  const Normal s = solve_normal(indefinite, {5, 4}, 1e-20, 0);
  EXPECT_LE(norm(difference(s.x, {1, 2})), 1e-10)
      << "||x - x*|| <= ||(A'A)^-1|| sqrt(epsilon), and rounding far below";
}

TEST(SolveNormalEquations, FindsTheLeastSquares) {
  solver::SparseMatrix A(4, 2, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {2, 0, 1}, {2, 1, 2}, {3, 0, 1}, {3, 1, 3}});
  // The line through (0, 1), (1, 3), (2, 4), (3, 4): 1.5 + t.
  const Normal s = solve_normal(A, {1, 3, 4, 4}, 1e-24, 0);
  EXPECT_LE(norm(difference(s.x, {1.5, 1})), 2e-12) << "the smallest eigenvalue of A'A is 1.4";
}

TEST(SolveNormalEquations, DoesWhatConjGradDoesWithTheNormalMatrix) {
  const int n = 60;
  std::vector<solver::SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i)
    entries.insert(entries.end(), {{i, i, 3.0}, {i, (i + 1) % n, -1.0}, {i, (i + 7) % n, 0.5}});
  solver::SparseMatrix A(n, n, entries), At = A.transposed();
  auto AtA = normal_matrix(n, n, &A, &At);
  for (int most : {-1, 0, 5, 100})
    for (double epsilon : {-1.0, 1e-10}) {
      const Solution expected = solve(*AtA, product(At, scattered(n), n), epsilon, most);
      const Normal s = solve_normal(A, scattered(n), epsilon, most);
      EXPECT_EQ(s.x, expected.x);
      EXPECT_EQ(s.squared_residual, expected.squared_residual);
      EXPECT_EQ(s.steps, expected.steps);
      EXPECT_EQ(s.products, 1 + s.steps + s.steps / 64);
      EXPECT_EQ(s.transposed_products, s.products + 1);
      EXPECT_EQ(s.b, scattered(n)) << "b is not changed";
    }
}

TEST(SolveNormalEquations, EndsWhereTheColumnsDepend) {
  const solver::SparseMatrix A(2, 3, {{0, 0, 1}, {0, 1, 1}, {1, 2, 1}});  // A'A is singular, A'b in its range
  const Normal s = solve_normal(A, {2, 5}, 1e-20, 0);
  EXPECT_LE(s.squared_residual, 1e-20);
  EXPECT_NEAR(s.x[0] + s.x[1], 2, 1e-10);
  EXPECT_NEAR(s.x[2], 5, 1e-10);
  EXPECT_FALSE(solve_normal(A, {kNaN, 1}, 1e-5, 0).squared_residual <= 1e-5);
  EXPECT_EQ(solve_normal(solver::SparseMatrix(2, 0, {}), {1, 2}, 0, 0).squared_residual, 0);
  EXPECT_EQ(solve_normal(solver::SparseMatrix(0, 2, {}), {}, 0, 0).x, (Vector{0, 0}));
}

}  // namespace
}  // namespace reference_tests
