// STAFF ONLY. S2 with dependent columns, and its allocations. The public checks test the promises of
// solver/normal_equations.h.

#include "solver/normal_equations.h"

#include <gtest/gtest.h>

#include <vector>

#include "solver/matrices.h"
#include "solver/test_allocations.h"
#include "solver/test_numbers.h"

namespace reference_tests {
namespace {

using Vector = std::vector<double>;

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

}  // namespace
}  // namespace reference_tests
