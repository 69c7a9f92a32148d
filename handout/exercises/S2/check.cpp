// The public checks of S2. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in solver/normal_equations.h. The checks of solve_normal_equations need S1: it calls
// your ConjGrad.

#include "solver/normal_equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check.h"

using namespace checks;
using solver::SparseMatrix;

namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

SparseMatrix dense(int rows, int cols, const Vector& a) {
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < cols; ++j) entries.push_back({i, j, a[i * cols + j]});
  return SparseMatrix(rows, cols, entries);
}

// The product A x. Its memory holds NaN before, so the product must overwrite all of it.
Vector multiply(implicitMatrix& A, int rows, Vector x) {
  const Vector before = x;
  Vector b(rows, kNaN);
  A.matVecMult(x.data(), b.data());
  EXPECT_EQ(x, before) << "matVecMult changed its input";
  return b;
}

void expect_same(const Vector& actual, const Vector& expected) {
  note_hint(actual, expected, 0);
  EXPECT_EQ(actual, expected);
}

// All that comes out of one call of solve_normal_equations.
struct Outcome {
  Vector x;
  double returned;
  int steps, products, transposed_products;
  Vector b;  // as it was left
};

Outcome solve(SparseMatrix& A, const Vector& b, double epsilon, int most_steps, double x_on_entry = 0) {
  SparseMatrix transposed = A.transposed();
  Counted counted(A), counted_transposed(transposed);
  Outcome out{Vector(A.cols(), x_on_entry), kNaN, most_steps, 0, 0, b};
  out.returned = solve_normal_equations(A.rows(), A.cols(), &counted, &counted_transposed, out.x.data(),
                                        out.b.data(), epsilon, &out.steps);
  out.products = counted.products;
  out.transposed_products = counted_transposed.products;
  return out;
}

std::string call(const std::string& name, double epsilon, int most_steps) {
  std::ostringstream text;
  text << "solve_normal_equations with " << name << ", epsilon = " << epsilon << ", *steps = " << most_steps;
  return text.str();
}

// The residual_gap of A'A x = A'b, plus the rounding of A'b itself.
double gap(System& s) {
  SparseMatrix transposed = s.A.transposed();
  const double norm_of_A = s.A.norm_bound(), e = s.A.longest_row(), e_transposed = transposed.longest_row();
  return residual_gap(norm_of_A * norm_of_A, e + e_transposed, s.solution, product(transposed, s.b)) +
         e_transposed * std::ldexp(1.0, -53) * norm_of_A * norm(s.b);
}

// ||A'(b - Ax)||
double residual(SparseMatrix& A, const Vector& b, const Vector& x) {
  SparseMatrix transposed = A.transposed();
  return norm(product(transposed, difference(b, product(A, x))));
}

void expect_solved(System& s, const Outcome& out, double epsilon) {
  expect_near(out.x, s.solution, (std::sqrt(epsilon) + gap(s)) / s.smallest,
              "(sqrt(epsilon) + (64 (10 + 2e) + n) u ||A||^2 X) / smallest eigenvalue of A'A: see "
              "solver/linearSolver.h");
}

}  // namespace

TEST(Table, MultipliesRowsByTheVector) {
  const Vector a = {1, 2, 3,  //
                    4, 5, 6};
  SCOPED_TRACE("dense_matrix of [1 2 3; 4 5 6], x = (1, 10, 100)");
  expect_same(multiply(*dense_matrix(2, 3, a.data()), 2, {1, 10, 100}), (Vector{321, 654}));
  SCOPED_TRACE("dense_matrix of [1 2; 3 4; 5 6], x = (1, 10)");
  expect_same(multiply(*dense_matrix(3, 2, a.data()), 3, {1, 10}), (Vector{21, 43, 65}));
}

TEST(Table, CopiesTheTable) {
  Vector a = {1, 2, 3, 4};
  auto A = dense_matrix(2, 2, a.data());
  a.assign(4, kNaN);
  SCOPED_TRACE("dense_matrix of [1 2; 3 4], whose table is overwritten before the product with x = (1, 1)");
  expect_same(multiply(*A, 2, {1, 1}), (Vector{3, 7}));
}

TEST(Table, WithoutColumnsGivesZeros) {
  SCOPED_TRACE("dense_matrix with 3 rows and no columns");
  expect_same(multiply(*dense_matrix(3, 0, nullptr), 3, {}), Vector(3, 0.0));
}

TEST(Units, TakesEntriesOfAnySize) {
  // Powers of two change no digit.
  const double tiny = std::ldexp(1.0, -300), large = std::ldexp(1.0, 200);
  const Vector a = {tiny, 2 * tiny, 3 * tiny, 4 * tiny};
  SCOPED_TRACE("dense_matrix of 2^-300 [1 2; 3 4], x = 2^200 (1, 3)");
  expect_same(multiply(*dense_matrix(2, 2, a.data()), 2, {large, 3 * large}),
              (Vector{7 * tiny * large, 15 * tiny * large}));
}

TEST(Table, RoundsNoMoreThanItMust) {
  const int rows = 40, cols = 25;
  const Vector a = scattered(rows * cols), x = scattered(cols);
  SparseMatrix A = dense(rows, cols, a);
  SCOPED_TRACE("dense_matrix of 40 x 25 scattered numbers");
  expect_near(multiply(*dense_matrix(rows, cols, a.data()), rows, x), product(A, x),
              2 * cols * std::ldexp(1.0, -53) * A.norm_bound() * norm(x),
              "2 n u ||A|| ||x||: a sum of n products rounds by at most n u, here and in the expected value");
}

TEST(NormalOperator, IsTheProductWithAThenWithItsTranspose) {
  SparseMatrix A = dense(3, 2, {1, 2, 3, 4, 5, 6}), transposed = A.transposed();
  auto normal = normal_matrix(3, 2, &A, &transposed);
  SCOPED_TRACE("normal_matrix of A = [1 2; 3 4; 5 6], A'A = [35 44; 44 56], x = (1, 10)");
  expect_same(multiply(*normal, 2, {1, 10}), (Vector{475, 604}));
  SCOPED_TRACE("the same matrix once more");
  expect_same(multiply(*normal, 2, {1, 0}), (Vector{35, 44}));
}

TEST(NormalOperator, WorksForMoreColumnsThanRows) {
  SparseMatrix A = dense(1, 3, {1, 2, 3}), transposed = A.transposed();
  SCOPED_TRACE("normal_matrix of A = [1 2 3], x = (1, 1, 1)");
  expect_same(multiply(*normal_matrix(1, 3, &A, &transposed), 3, {1, 1, 1}), (Vector{6, 12, 18}));
}

TEST(Nested, WorksInsideOfAnother) {
  SparseMatrix A = dense(3, 2, {1, 2, 3, 4, 5, 6}), transposed = A.transposed();
  auto inner = normal_matrix(3, 2, &A, &transposed);
  auto outer = normal_matrix(2, 2, inner.get(), inner.get());
  SCOPED_TRACE("normal_matrix of the normal_matrix of A = [1 2; 3 4; 5 6], [35 44; 44 56]^2, x = (1, 0)");
  expect_same(multiply(*outer, 2, {1, 0}), (Vector{3161, 4004}));
}

TEST(Units, TakesMatricesOfAnySize) {
  const double tiny = std::ldexp(1.0, -200), large = std::ldexp(1.0, 300);
  SparseMatrix A = dense(2, 2, {tiny, 2 * tiny, 3 * tiny, 4 * tiny}), transposed = A.transposed();
  SCOPED_TRACE("normal_matrix of A = 2^-200 [1 2; 3 4], A'A = 2^-400 [10 14; 14 20], x = 2^300 (1, 1)");
  expect_same(multiply(*normal_matrix(2, 2, &A, &transposed), 2, {large, large}),
              (Vector{24 * (tiny * (tiny * large)), 34 * (tiny * (tiny * large))}));
}

TEST(NormalOperator, TakesOneProductWithEachMatrix) {
  SparseMatrix A = dense(3, 2, {1, 2, 3, 4, 5, 6}), transposed = A.transposed();
  Counted counted(A), counted_transposed(transposed);
  auto normal = normal_matrix(3, 2, &counted, &counted_transposed);
  EXPECT_COUNT(counted.products + counted_transposed.products, 0) << "normal_matrix itself takes no product";
  multiply(*normal, 2, {1, 10});
  EXPECT_COUNT(counted.products, 1) << "products with A";
  EXPECT_COUNT(counted_transposed.products, 1) << "products with A'";
}

TEST(Systems, SolvesANonSymmetricSystem) {
  System s{"A = [1 2; 0 1], b = (5, 2)", dense(2, 2, {1, 2, 0, 1}), {5, 2}, {1, 2}, 0.17};
  SCOPED_TRACE(call(s.name, 1e-20, 100));
  expect_solved(s, solve(s.A, s.b, 1e-20, 100), 1e-20);
}

TEST(Systems, SolvesASymmetricIndefiniteSystem) {
  System s{"A = [1 2; 2 -1.5], b = (7, 3)", dense(2, 2, {1, 2, 2, -1.5}), {7, 3}, {3, 2}, 4.4};
  SCOPED_TRACE(call(s.name, 1e-20, 100));
  expect_solved(s, solve(s.A, s.b, 1e-20, 100), 1e-20);
}

TEST(Systems, FitsALineByLeastSquares) {
  System s{"A = [1 0; 1 1; 1 2], b = (6, 0, 0)", dense(3, 2, {1, 0, 1, 1, 1, 2}), {6, 0, 0}, {5, -3}, 0.83};
  SCOPED_TRACE(call(s.name, 1e-20, 100));
  expect_solved(s, solve(s.A, s.b, 1e-20, 100), 1e-20);
}

TEST(Systems, SolvesForMoreUnknownsThanEquations) {
  SparseMatrix A = dense(3, 40, scattered(120));
  SCOPED_TRACE(call("3 x 40 scattered numbers, b = (25, 7, -4)", 1e-16, 100));
  EXPECT_LE(residual(A, {25, 7, -4}, solve(A, {25, 7, -4}, 1e-16, 100).x), 2e-8)
      << "||A'(b - Ax)||; bound: sqrt(epsilon), and as much for rounding";
}

TEST(Systems, OnlyWritesX) {
  SparseMatrix A = dense(3, 2, {1, 0, 1, 1, 1, 2});
  const Outcome from_zeros = solve(A, {6, 0, 0}, 1e-20, 100);
  SCOPED_TRACE(call("A = [1 0; 1 1; 1 2], b = (6, 0, 0), NaN in x on entry", 1e-20, 100));
  expect_same(solve(A, {6, 0, 0}, 1e-20, 100, kNaN).x, from_zeros.x);
}

TEST(StepsAndProducts, ReturnsTheSquaredNormOfTheNormalEquationsResidual) {
  const int rows = 30, cols = 20;
  SparseMatrix A = dense(rows, cols, scattered(rows * cols));
  System s{"30 x 20 scattered numbers", A, scattered(rows), Vector(cols, 0.0), 0};
  s.solution = solve(A, s.b, 1e-26, 0).x;  // Only its length counts, in the bound.
  for (int most_steps : {1, 4}) {
    SCOPED_TRACE(call(s.name, 0, most_steps));
    const Outcome out = solve(A, s.b, 0, most_steps);
    const double left = residual(A, s.b, out.x);
    EXPECT_LE(std::abs(std::sqrt(out.returned) - left), gap(s))
        << "returned " << out.returned << "; ||A'(b - Ax)||^2 = " << left * left
        << "; bound: (64 (10 + 2e) + n) u ||A||^2 X on the roots' difference, see solver/linearSolver.h";
  }
}

TEST(StepsAndProducts, TakesTheStepsAndProductsThatItMay) {
  const int rows = 90, cols = 80;
  SparseMatrix A = dense(rows, cols, scattered(rows * cols));
  for (int most_steps : {1, 5, 70}) {
    SCOPED_TRACE(call("90 x 80 scattered numbers", 0, most_steps));
    const Outcome out = solve(A, scattered(rows), 0, most_steps);
    EXPECT_COUNT(out.steps, most_steps);
    EXPECT_COUNT(out.products, 1 + most_steps + most_steps / 64) << "products with A";
    EXPECT_COUNT(out.transposed_products, out.products + 1) << "products with A', which A'b takes one of";
    EXPECT_EQ(out.b, scattered(rows)) << "solve_normal_equations changed b";
  }
}

TEST(StepsAndProducts, HandsEpsilonOn) {
  // ConjGrad's own answer to the same system says which step meets epsilon first.
  SparseMatrix A = dense(30, 20, scattered(600)), transposed = A.transposed();
  const Vector b = scattered(30);
  Vector right_side = product(transposed, b), x(20);
  const auto normal = normal_matrix(30, 20, &A, &transposed);
  for (double epsilon : {1e3, 1e-3, 1e-12}) {
    SCOPED_TRACE(call("30 x 20 scattered numbers", epsilon, 100));
    int steps = 100;
    ConjGrad(20, normal.get(), x.data(), right_side.data(), epsilon, &steps);
    EXPECT_COUNT(solve(A, b, epsilon, 100).steps, steps) << "the steps of ConjGrad itself";
  }
}

TEST(Systems, AgreesWithTheGoldenData) {
  for (Golden& golden : read_golden("S2")) {
    System& s = golden.system;
    SCOPED_TRACE(call(s.name, golden.epsilon, 0));
    const Outcome out = solve(s.A, s.b, golden.epsilon, 0);
    EXPECT_COUNT(out.steps, golden.steps);
    expect_near(
        out.x, s.solution, 2 * (std::sqrt(golden.epsilon) + gap(s)) / s.smallest,
        "2 (sqrt(epsilon) + (64 (10 + 2e) + n) u ||A||^2 X) / smallest eigenvalue of A'A, for either x may "
        "be off by half");
  }
}

int main(int argc, char** argv) {
  static SparseMatrix empty = solver::diagonal({});
  return run(argc, argv,
             {{"dense_matrix", [] { dense_matrix(0, 0, nullptr); }},
              {"normal_matrix", [] { normal_matrix(0, 0, &empty, &empty); }},
              {"solve_normal_equations",
               [] {
                 double none = 0;
                 int steps = 0;
                 solve_normal_equations(0, 0, &empty, &empty, &none, &none, 1, &steps);
               },
               {"normal_matrix"}}});
}
