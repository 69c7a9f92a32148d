// STAFF ONLY. S2: hidden cases of dense_matrix, normal_matrix and solve_normal_equations.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "reference/S2/calls.h"

namespace grader::s2 {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The product with sums that hardly round.
VectorXd times(const Matrix& A, const VectorXd& x) {
  return (A.cast<long double>() * x.cast<long double>()).cast<double>();
}

Matrix table_of(int rows, int cols, const VectorXd& entries) {
  return Eigen::Map<const Matrix>(entries.data(), rows, cols);
}

Matrix random_table(Random& random, int rows, int cols) {
  return table_of(rows, cols, random_vector(random, Eigen::Index{rows} * cols));
}

std::string in_words(const Matrix& A) {
  return std::to_string(A.rows()) + " x " + std::to_string(A.cols());
}

// Serves A and A', and counts.
struct Counted {
  Matrix A, A_transposed;
  int products = 0, transposed_products = 0, most = 1 << 20;

  explicit Counted(const Matrix& matrix) : A(matrix), A_transposed(matrix.transpose()) {}

  Served served() { return serve(A, products); }
  Served served_transposed() { return serve(A_transposed, transposed_products); }

 private:
  Served serve(const Matrix& matrix, int& count) {
    return {static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()),
            [this, &matrix, &count](int, const std::vector<double>& x, std::vector<double>& y) {
              if (static_cast<Eigen::Index>(x.size()) != matrix.cols())
                throw MalformedMessage("a product that makes no sense");
              const VectorXd product = times(matrix, VectorXd::Map(x.data(), matrix.cols()));
              y.assign(product.begin(), product.end());
              return ++count <= most;
            }};
  }
};

// Compares two products with the same x, into buffers with junk. Entries may be off by `rounding`.
void expect_products(Trial& trial, const std::vector<VectorXd>& products, const VectorXd& expected,
                     double rounding, const std::string& what) {
  trial.expect_close({products[0], expected, 1}, rounding, "the error of " + what);
  // Both products have the same x, so a product that changes x shows here.
  trial.expect(products[0] == products[1], what + " gives another result the second time");
}

void expect_dense_product(Trial& trial, const std::string& name, const Matrix& matrix, const VectorXd& x) {
  trial.describe(name + ", " + in_words(matrix));
  const int rows = static_cast<int>(matrix.rows()), cols = static_cast<int>(matrix.cols());
  const VectorXd entries = VectorXd::Map(matrix.data(), matrix.size());
  // The table is the caller's, who may change it.
  const VectorXd changed = VectorXd::Constant(entries.size(), kNaN);
  for (double junk : {0.0, 1e3, kNaN}) {
    CaseAsker asker(trial);
    const auto answer =
        Client<Calls, dense>::multiply(asker, 2, x, VectorXd::Constant(rows, junk),
                                       std::tie(rows, cols, entries), std::tie(rows, cols, changed));
    // Each entry is a dot product of `cols` terms.
    expect_products(trial, answer.products, times(matrix, x), kUnit * (cols + 1) * matrix.norm() * x.norm(),
                    "dense_matrix's product");
  }
}

struct NormalSolution {
  double value;
  int steps;
  VectorXd x;
  int products, transposed_products;  // as the suite counted them
};

// Calls the student's solve_normal_equations, `calls` times with the same b.
NormalSolution solve(Trial& trial, const std::string& name, const Matrix& matrix, const VectorXd& b,
                     double epsilon, int steps, int calls = 1) {
  trial.describe(name + ", " + in_words(matrix));
  Counted counted(matrix);
  const int limit = steps == 0 ? std::max(100, 2 * static_cast<int>(matrix.cols())) : std::max(0, steps);
  counted.most = 2 * calls * (limit + limit / 64 + 4);  // products of both kinds together
  VectorXd right_side = b;                              // it goes from call to call, with any change to it
  NormalSolution solution;
  CaseAsker asker(trial);
  for (int call = 0; call < calls; ++call) {
    solution.x = VectorXd::Constant(matrix.cols(), kNaN);
    solution.steps = steps;
    solution.value = ask<Calls, solve_normal>(asker, counted.served(), counted.served_transposed(),
                                              solution.x, right_side, epsilon, solution.steps);
  }
  trial.expect(solution.steps >= 0 && solution.steps <= limit + 1,
               "the number of steps is negative, or far beyond the limit", std::to_string(solution.steps));
  solution.products = counted.products;
  solution.transposed_products = counted.transposed_products;
  return solution;
}

// The drift of linear_system.h for the matrix A'A, whose products have the error of two dot products.
double drift(const Matrix& table, const VectorXd& x, const VectorXd& Atb) {
  const double error = static_cast<double>(table.rows() + table.cols() + 2);
  return kUnit *
         (65 * (10 + 2 * error) * table.squaredNorm() * (2 * x.norm() + Atb.norm()) + 2 * error * Atb.norm());
}

// ||A'(b - Ax)||, by the suite's own products.
double normal_residual(const Matrix& table, const VectorXd& x, const VectorXd& b) {
  return times(table.transpose(), b - times(table, x)).norm();
}

// x solves A'A x = A'b up to epsilon and rounding, and so is close to `expected`. `smallest` is a lower
// bound of A's smallest singular value.
void expect_solves(Trial& trial, const std::string& name, const Matrix& table, VectorXd b, VectorXd expected,
                   double smallest) {
  // With ||A'b|| = 1 a relative epsilon is the same. The meaning of epsilon is for steps_and_products.
  const double length = times(table.transpose(), b).norm();
  b /= length;
  expected /= length;
  const VectorXd Atb = times(table.transpose(), b);
  const NormalSolution solution = solve(trial, name, table, b, 1e-18, 0);
  const Bound allowed{1e-9, drift(table, expected, Atb)},
      bound{allowed.promised / (smallest * smallest), allowed.rest / (smallest * smallest)};
  const Compared numbers{solution.x, expected, 1, Atb, bound.most()};
  trial.expect_at_most(normal_residual(table, solution.x, b), allowed, "the norm of A'(b - Ax)", numbers);
  trial.expect_at_most((solution.x - expected).norm(), bound, "the error of x", numbers);
}

// A = D + N, where D is diagonal with entries of size `large` or more, and ||N||_F <= 1. So no singular value
// is below large - 1.
Matrix dominant(Random& random, const VectorXd& diagonal) {
  const int n = static_cast<int>(diagonal.size());
  Matrix table = random_table(random, n, n);
  table /= table.norm();
  table.diagonal() += diagonal;
  return table;
}

VectorXd uniform_vector(Random& random, int n, double low, double high) {
  VectorXd values(n);
  for (double& value : values) value = random.uniform(low, high);
  return values;
}

Matrix symmetric(const Matrix& A) {
  return A.selfadjointView<Eigen::Upper>();
}

}  // namespace

void table(Trial& trial) {
  Random& random = trial.random;
  expect_dense_product(trial, "Example 1", table_of(2, 2, Eigen::Vector4d(2, 0, 0, 1)),
                       Eigen::Vector2d(0.5, 1));
  expect_dense_product(trial, "Example 2", table_of(2, 2, Eigen::Vector4d(2, 1, 1, 1)),
                       Eigen::Vector2d(-1, 5));
  for (auto [rows, cols] : {std::pair{1, 1}, {3, 3}, {7, 4}, {4, 7}, {1, 9}, {9, 1}, {60, 50}}) {
    const Matrix table = random_table(random, rows, cols);
    expect_dense_product(trial, "random", table, random_vector(random, cols));
  }
  expect_dense_product(trial, "no columns", Matrix(3, 0), VectorXd(0));
  expect_dense_product(trial, "no rows", Matrix(0, 3), random_vector(random, 3));
}

void normal_operator(Trial& trial) {
  Random& random = trial.random;
  for (auto [rows, cols] : {std::pair{2, 2}, {5, 5}, {9, 4}, {4, 9}, {40, 30}}) {
    const Matrix table = random_table(random, rows, cols);
    const VectorXd x = random_vector(random, cols);
    trial.describe("A'A, A " + in_words(table));
    Counted counted(table);
    const VectorXd junk = random_vector(random, cols, 1e3);
    CaseAsker asker(trial);
    const auto answer = Client<Calls, normal>::multiply(
        asker, 2, x, junk, std::tuple(counted.served(), counted.served_transposed()));
    const double rounding = kUnit * (rows + cols + 2) * table.squaredNorm() * x.norm();
    expect_products(trial, answer.products, times(table.transpose(), times(table, x)), rounding,
                    "normal_matrix's product");
    trial.expect(counted.products == 2 && counted.transposed_products == 2,
                 "a product with A'A does not take one product with A and one with A'",
                 std::to_string(counted.products) + " and " + std::to_string(counted.transposed_products) +
                     " for two");
  }
}

// Compares A'A A'A x for a symmetric A. Each of the four products may be off by its dot products' rounding,
// and the later ones multiply that.
void nested(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 5, 8}) {
    const Matrix table = symmetric(random_table(random, n, n));
    const VectorXd x = random_vector(random, n);
    trial.describe("A'A of A'A, A " + in_words(table));
    Counted counted(table);
    CaseAsker asker(trial);
    const auto answer =
        Client<Calls, normal_of_normal>::multiply(asker, 2, x, random_vector(random, n, 1e3),
                                                  std::tuple(counted.served(), counted.served_transposed()));
    expect_products(trial, answer.products, times(table, times(table, times(table, times(table, x)))),
                    4 * kUnit * (n + 1) * std::pow(table.norm(), 4) * x.norm(),
                    "the product of normal_matrix of a normal_matrix");
  }
}

// A product works in each unit, and powers of two round nothing.
void units(Trial& trial) {
  Random& random = trial.random;
  const Matrix table = random_table(random, 4, 4);
  const VectorXd x = random_vector(random, 4);
  const auto products = [&](double unit) {
    const Matrix scaled = unit * table;
    const VectorXd entries = VectorXd::Map(scaled.data(), 16), in = unit * x;
    const int size = 4;
    trial.describe("a matrix and a vector in units of " + std::to_string(std::log2(unit)) + " binary places");
    Counted counted(scaled);
    CaseAsker asker(trial);
    const VectorXd dense_product =
        Client<Calls, dense>::multiply(asker, 1, in, VectorXd::Zero(4), std::tie(size, size, entries),
                                       std::tie(size, size, entries))
            .products[0];
    const VectorXd normal_product =
        Client<Calls, normal>::multiply(asker, 1, in, VectorXd::Zero(4),
                                        std::tuple(counted.served(), counted.served_transposed()))
            .products[0];
    return std::pair{dense_product, normal_product};
  };
  const auto [dense_product, normal_product] = products(1);
  trial.expect(dense_product.norm() > 0 && normal_product.norm() > 0, "the products are 0");
  for (double unit : {0x1p-120, 0x1p120}) {
    const auto [dense_scaled, normal_scaled] = products(unit);
    trial.expect(dense_scaled == unit * unit * dense_product,
                 "dense_matrix does other things to a table of very small or very large numbers");
    trial.expect(normal_scaled == unit * unit * unit * normal_product,
                 "normal_matrix does other things to a matrix of very small or very large numbers");
  }
}

namespace {

void expect_solves_non_symmetric(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 10, 40}) {
    const VectorXd diagonal = uniform_vector(random, n, 2, 6);
    const Matrix A = dominant(random, diagonal);
    const VectorXd x = random_vector(random, n);
    expect_solves(trial, "non-symmetric", A, times(A, x), x, 1);
  }
  // A is a rotation: A'A is the identity, so the first guess is the solution.
  const double angle = random.uniform(0.5, 1);
  const Matrix rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
  const VectorXd x = random_vector(random, 2);
  expect_solves(trial, "rotation", rotation, times(rotation, x), x, 0.99);
}

void expect_solves_indefinite(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 5, 20}) {
    VectorXd diagonal = uniform_vector(random, n, 2, 6);
    for (int i = 1; i < n; i += 2) diagonal[i] *= -1;
    const Matrix A = symmetric(dominant(random, diagonal));
    // Made symmetric, the part beside the diagonal is no longer than sqrt(2).
    const VectorXd x = random_vector(random, n);
    expect_solves(trial, "symmetric, indefinite", A, times(A, x), x, 2 - std::sqrt(2.0));
  }
  // The saddle point [[1, 1], [1, 0]] has the eigenvalues (1 -+ sqrt(5)) / 2.
  expect_solves(trial, "saddle point", table_of(2, 2, Eigen::Vector4d(1, 1, 1, 0)), Eigen::Vector2d(3, 1),
                Eigen::Vector2d(1, 2), 0.618);
}

void expect_least_squares(Trial& trial) {
  Random& random = trial.random;
  for (auto [rows, cols] : {std::pair{6, 3}, {30, 10}}) {
    // A = Q [B; 0] with an orthogonal Q has B's singular values, at least 1. Q [0; z] is orthogonal to its
    // columns, so b = A x + Q [0; z] has the solution x.
    const VectorXd diagonal = uniform_vector(random, cols, 2, 5);
    const Matrix B = dominant(random, diagonal);
    const VectorXd mirror = random_vector(random, rows).normalized();
    const Matrix Q = Matrix::Identity(rows, rows) - 2 * mirror * mirror.transpose();
    const Matrix A = Q.leftCols(cols) * B;
    const VectorXd unreachable = Q.rightCols(rows - cols) * random_vector(random, rows - cols),
                   x = random_vector(random, cols), b = times(A, x) + unreachable;
    // Rounding leaves A'Q[0; z] at u ||A|| ||z||, within the drift's allowance.
    expect_solves(trial, "least squares", A, b, x, 0.99);
  }
  // With fewer rows than columns A'A is singular, and any solution x passes. The first guess, A'b, is in its
  // range.
  for (auto [rows, cols] : {std::pair{2, 5}, {3, 40}}) {
    const Matrix A = random_table(random, rows, cols);
    VectorXd b = random_vector(random, rows);
    b /= times(A.transpose(), b).norm();
    const NormalSolution solution = solve(trial, "fewer rows than columns", A, b, 1e-12, 0);
    trial.expect_at_most(normal_residual(A, solution.x, b),
                         1e-6 + drift(A, solution.x, times(A.transpose(), b)), "the norm of A'(b - Ax)");
  }
}

}  // namespace

void systems(Trial& trial) {
  expect_solves_non_symmetric(trial);
  expect_solves_indefinite(trial);
  expect_least_squares(trial);
}

// A is symmetric here, so the order of the two products does not matter.
void steps_and_products(Trial& trial) {
  Random& random = trial.random;
  const int n = random.integer(12, 18);
  const VectorXd diagonal = uniform_vector(random, n, 2, 20);
  const Matrix A = symmetric(dominant(random, diagonal));
  const VectorXd x = random_vector(random, n), b = times(A, x), Atb = times(A.transpose(), b);
  expect_solves(trial, "ordinary", A, b, x, 1);
  // epsilon decides here: it is a little more than the residual after three steps, in a unit in which no
  // length is 1.
  const VectorXd large = 0x1p20 * b;
  const double left = normal_residual(A, solve(trial, "three steps", A, large, 0, 3).x, large);
  const NormalSolution ended =
      solve(trial, "what three steps reach", A, large, std::pow(1.001 * left, 2), 50);
  trial.expect(ended.steps <= 3 && normal_residual(A, ended.x, large) <= 1.01 * left,
               "ConjGrad gets another epsilon", std::to_string(ended.steps) + " steps");
  // The second call finds b as it was.
  const NormalSolution once = solve(trial, "one call", A, b, 0, 5),
                       twice = solve(trial, "two calls", A, b, 0, 5, 2);
  trial.expect(once.x == twice.x, "a second call with the same b gives another x");

  struct Limit {
    const char* name;
    double epsilon;
    int limit, expected;
  };
  for (const Limit& one : {Limit{"one step", 0, 1, 1},
                           {"three steps", 0, 3, 3},
                           {"no steps", 0, -1, 0},
                           {"many steps", 0, 70, 70},
                           {"a huge epsilon", 1e300, 0, 0}}) {
    const NormalSolution solution = solve(trial, one.name, A, b, one.epsilon, one.limit);
    trial.expect(solution.steps == one.expected, "the step limit and epsilon are not ConjGrad's",
                 std::to_string(solution.steps));
    const int expected = 1 + solution.steps + solution.steps / 64;
    trial.expect(solution.products + solution.transposed_products == 2 * expected + 1,
                 "the number of products is not 1 + steps + floor(steps / 64) with A, and one more with A'",
                 std::to_string(solution.products) + " and " + std::to_string(solution.transposed_products));
    trial.expect_at_most(std::abs(std::sqrt(solution.value) - normal_residual(A, solution.x, b)),
                         drift(A, x, Atb) + kUnit * (n + 2) * std::sqrt(solution.value),
                         "the difference between the return value and the squared norm of A'(b - Ax)");
  }
}

}  // namespace grader::s2
