// STAFF ONLY. S2: hidden cases of dense_matrix, normal_matrix and solve_normal_equations.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/linear_system.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "reference/S2/calls.h"

namespace grader::s2 {
namespace {

using Eigen::VectorXd;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A matrix with products on the trusted side.
struct Matrix {
  int rows, cols;
  std::vector<double> entries;  // by rows

  std::vector<double> times(const std::vector<double>& x) const {
    std::vector<double> y(rows);
    for (int i = 0; i < rows; ++i) {
      long double sum = 0;
      for (int j = 0; j < cols; ++j) sum += static_cast<long double>(entries[i * cols + j]) * x[j];
      y[i] = static_cast<double>(sum);
    }
    return y;
  }
  Matrix transposed() const {
    Matrix result{cols, rows, std::vector<double>(entries.size())};
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < cols; ++j) result.entries[j * rows + i] = entries[i * cols + j];
    return result;
  }
  double norm() const { return grader::norm(entries); }  // Frobenius, >= ||A||
};

Matrix random_table(Random& random, int rows, int cols) {
  return {rows, cols, random.normals(rows * cols)};
}

// Serves A and A', and counts.
struct Counted {
  Matrix A, A_transposed;
  int products = 0, transposed_products = 0, most = 1 << 20;

  explicit Counted(const Matrix& matrix) : A(matrix), A_transposed(matrix.transposed()) {}

  Served served() { return serve(A, products); }
  Served served_transposed() { return serve(A_transposed, transposed_products); }

 private:
  Served serve(const Matrix& matrix, int& count) {
    return {matrix.rows, matrix.cols,
            [this, &matrix, &count](int, const std::vector<double>& x, std::vector<double>& y) {
              if (static_cast<int>(x.size()) != matrix.cols)
                throw MalformedMessage("a product that makes no sense");
              y = matrix.times(x);
              return ++count <= most;
            }};
  }
};

std::vector<double> numbers_in(const VectorXd& values) {
  return {values.begin(), values.end()};
}

// Compares two products with the same x, into buffers with junk. Entries may be off by `rounding`.
void expect_products(Trial& trial, const std::vector<VectorXd>& products, const std::vector<double>& expected,
                     double rounding, const std::string& what) {
  trial.expect_at_most(distance(numbers_in(products[0]), expected), rounding, "the error of " + what,
                       {products[0], vector_of(expected), 1});
  // Both products have the same x, so a product that changes x shows here.
  trial.expect(products[0] == products[1], what + " gives another result the second time");
}

void expect_dense_product(Trial& trial, const std::string& name, const Matrix& matrix,
                          const std::vector<double>& x) {
  trial.describe(name + ", " + std::to_string(matrix.rows) + " x " + std::to_string(matrix.cols));
  const VectorXd entries = vector_of(matrix.entries);
  // The table is the caller's, who may change it.
  const VectorXd changed = VectorXd::Constant(entries.size(), kNaN);
  for (double junk : {0.0, 1e3, kNaN}) {
    CaseAsker asker(trial);
    const auto answer = Client<Calls, dense>::multiply(
        asker, 2, vector_of(x), VectorXd::Constant(matrix.rows, junk),
        std::tie(matrix.rows, matrix.cols, entries), std::tie(matrix.rows, matrix.cols, changed));
    // Each entry is a dot product of `cols` terms.
    expect_products(trial, answer.products, matrix.times(x),
                    kUnit * (matrix.cols + 1) * matrix.norm() * norm(x), "dense_matrix's product");
  }
}

struct NormalSolution {
  double value;
  int steps;
  std::vector<double> x;
  int products, transposed_products;  // as the suite counted them
};

// Calls the student's solve_normal_equations, `calls` times with the same b.
NormalSolution solve(Trial& trial, const std::string& name, const Matrix& matrix,
                     const std::vector<double>& b, double epsilon, int steps, int calls = 1) {
  trial.describe(name + ", " + std::to_string(matrix.rows) + " x " + std::to_string(matrix.cols));
  Counted counted(matrix);
  const int limit = steps == 0 ? std::max(100, 2 * matrix.cols) : std::max(0, steps);
  counted.most = 2 * calls * (limit + limit / 64 + 4);  // products of both kinds together
  VectorXd x, right_side = vector_of(b);                // b goes from call to call, with any change to it
  NormalSolution solution;
  CaseAsker asker(trial);
  for (int call = 0; call < calls; ++call) {
    x = VectorXd::Constant(matrix.cols, kNaN);
    solution.steps = steps;
    solution.value = ask<Calls, solve_normal>(asker, counted.served(), counted.served_transposed(), x,
                                              right_side, epsilon, solution.steps);
  }
  solution.x = numbers_in(x);
  trial.expect(solution.steps >= 0 && solution.steps <= limit + 1,
               "the number of steps is negative, or far beyond the limit", std::to_string(solution.steps));
  solution.products = counted.products;
  solution.transposed_products = counted.transposed_products;
  return solution;
}

// The drift of linear_system.h for the matrix A'A, whose products have the error of two dot products.
double drift(const Matrix& table, const std::vector<double>& x, const std::vector<double>& Atb) {
  const double error = table.rows + table.cols + 2, squared = table.norm() * table.norm();
  return kUnit * (65 * (10 + 2 * error) * squared * (2 * norm(x) + norm(Atb)) + 2 * error * norm(Atb));
}

// ||A'(b - Ax)||, by the suite's own products.
double normal_residual(const Matrix& table, const std::vector<double>& x, std::vector<double> b) {
  const std::vector<double> Ax = table.times(x);
  for (std::size_t i = 0; i < b.size(); ++i) b[i] -= Ax[i];
  return norm(table.transposed().times(b));
}

// x solves A'A x = A'b up to epsilon and rounding, and so is close to `expected`. `smallest` is a lower
// bound of A's smallest singular value.
void expect_solves(Trial& trial, const std::string& name, const Matrix& table, std::vector<double> b,
                   std::vector<double> expected, double smallest) {
  // With ||A'b|| = 1 a relative epsilon is the same. The meaning of epsilon is for steps_and_products.
  const double length = norm(table.transposed().times(b));
  for (std::vector<double>* vector : {&b, &expected})
    for (double& value : *vector) value /= length;
  const std::vector<double> Atb = table.transposed().times(b);
  const NormalSolution solution = solve(trial, name, table, b, 1e-18, 0);
  const Bound allowed{1e-9, drift(table, expected, Atb)},
      bound{allowed.promised / (smallest * smallest), allowed.rest / (smallest * smallest)};
  const Compared numbers{vector_of(solution.x), vector_of(expected), 1, vector_of(Atb), bound.most()};
  trial.expect_at_most(normal_residual(table, solution.x, b), allowed, "the norm of A'(b - Ax)", numbers);
  trial.expect_at_most(distance(solution.x, expected), bound, "the error of x", numbers);
}

// A = D + N, where D is diagonal with entries of size `large` or more, and ||N||_F <= 1. So no singular value
// is below large - 1.
Matrix dominant(Random& random, const std::vector<double>& diagonal) {
  const int n = static_cast<int>(diagonal.size());
  Matrix table = random_table(random, n, n);
  const double scale = 1 / table.norm();
  for (double& entry : table.entries) entry *= scale;
  for (int i = 0; i < n; ++i) table.entries[i * n + i] += diagonal[i];
  return table;
}

Matrix symmetric(Matrix A) {
  for (int i = 0; i < A.rows; ++i)
    for (int j = 0; j < i; ++j) A.entries[i * A.cols + j] = A.entries[j * A.cols + i];
  return A;
}

}  // namespace

void table(Trial& trial) {
  Random& random = trial.random;
  expect_dense_product(trial, "Example 1", {2, 2, {2, 0, 0, 1}}, {0.5, 1});
  expect_dense_product(trial, "Example 2", {2, 2, {2, 1, 1, 1}}, {-1, 5});
  for (auto [rows, cols] : {std::pair{1, 1}, {3, 3}, {7, 4}, {4, 7}, {1, 9}, {9, 1}, {60, 50}}) {
    const Matrix table = random_table(random, rows, cols);
    expect_dense_product(trial, "random", table, random.normals(cols));
  }
  expect_dense_product(trial, "no columns", {3, 0, {}}, {});
  expect_dense_product(trial, "no rows", {0, 3, {}}, random.normals(3));
}

void normal_operator(Trial& trial) {
  Random& random = trial.random;
  for (auto [rows, cols] : {std::pair{2, 2}, {5, 5}, {9, 4}, {4, 9}, {40, 30}}) {
    const Matrix table = random_table(random, rows, cols);
    const std::vector<double> x = random.normals(cols);
    trial.describe("A'A, A " + std::to_string(rows) + " x " + std::to_string(cols));
    Counted counted(table);
    const VectorXd junk = vector_of(random.normals(cols, 1e3));
    CaseAsker asker(trial);
    const auto answer = Client<Calls, normal>::multiply(
        asker, 2, vector_of(x), junk, std::tuple(counted.served(), counted.served_transposed()));
    const double rounding = kUnit * (rows + cols + 2) * table.norm() * table.norm() * norm(x);
    expect_products(trial, answer.products, table.transposed().times(table.times(x)), rounding,
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
    const std::vector<double> x = random.normals(n);
    trial.describe("A'A of A'A, A " + std::to_string(n) + " x " + std::to_string(n));
    Counted counted(table);
    CaseAsker asker(trial);
    const auto answer =
        Client<Calls, normal_of_normal>::multiply(asker, 2, vector_of(x), vector_of(random.normals(n, 1e3)),
                                                  std::tuple(counted.served(), counted.served_transposed()));
    expect_products(trial, answer.products, table.times(table.times(table.times(table.times(x)))),
                    4 * kUnit * (n + 1) * std::pow(table.norm(), 4) * norm(x),
                    "the product of normal_matrix of a normal_matrix");
  }
}

// A product works in each unit, and powers of two round nothing.
void units(Trial& trial) {
  Random& random = trial.random;
  const Matrix table = random_table(random, 4, 4);
  const std::vector<double> x = random.normals(4);
  const auto products = [&](double unit) {
    Matrix scaled = table;
    for (double& entry : scaled.entries) entry *= unit;
    VectorXd entries = vector_of(scaled.entries), in = unit * vector_of(x);
    trial.describe("a matrix and a vector in units of " + std::to_string(std::log2(unit)) + " binary places");
    Counted counted(scaled);
    CaseAsker asker(trial);
    const VectorXd dense_product = Client<Calls, dense>::multiply(asker, 1, in, VectorXd::Zero(4),
                                                                  std::tie(scaled.rows, scaled.cols, entries),
                                                                  std::tie(scaled.rows, scaled.cols, entries))
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
    std::vector<double> diagonal(n);
    for (double& value : diagonal) value = random.uniform(2, 6);
    const Matrix A = dominant(random, diagonal);
    const std::vector<double> x = random.normals(n);
    expect_solves(trial, "non-symmetric", A, A.times(x), x, 1);
  }
  // A is a rotation: A'A is the identity, so the first guess is the solution.
  const double angle = random.uniform(0.5, 1);
  const Matrix rotation{2, 2, {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)}};
  const std::vector<double> x = random.normals(2);
  expect_solves(trial, "rotation", rotation, rotation.times(x), x, 0.99);
}

void expect_solves_indefinite(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 5, 20}) {
    std::vector<double> diagonal(n);
    for (int i = 0; i < n; ++i) diagonal[i] = (i % 2 == 0 ? 1 : -1) * random.uniform(2, 6);
    const Matrix A = symmetric(dominant(random, diagonal));
    // Made symmetric, the part beside the diagonal is no longer than sqrt(2).
    const std::vector<double> x = random.normals(n);
    expect_solves(trial, "symmetric, indefinite", A, A.times(x), x, 2 - std::sqrt(2.0));
  }
  // The saddle point [[1, 1], [1, 0]] has the eigenvalues (1 -+ sqrt(5)) / 2.
  expect_solves(trial, "saddle point", {2, 2, {1, 1, 1, 0}}, {3, 1}, {1, 2}, 0.618);
}

void expect_least_squares(Trial& trial) {
  Random& random = trial.random;
  for (auto [rows, cols] : {std::pair{6, 3}, {30, 10}}) {
    // A = Q [B; 0] with an orthogonal Q has B's singular values, at least 1. Q [0; z] is orthogonal to its
    // columns, so b = A x + Q [0; z] has the solution x.
    std::vector<double> diagonal(cols);
    for (double& value : diagonal) value = random.uniform(2, 5);
    const Matrix B = dominant(random, diagonal);
    std::vector<double> mirror = random.normals(rows);
    const double length = norm(mirror);
    for (double& value : mirror) value /= length;
    auto reflect = [&](std::vector<double> v) {
      double dot = 0;
      for (std::size_t i = 0; i < mirror.size(); ++i) dot += mirror[i] * v[i];
      for (std::size_t i = 0; i < mirror.size(); ++i) v[i] -= 2 * dot * mirror[i];
      return v;
    };
    Matrix A{rows, cols, std::vector<double>(rows * cols)};
    for (int j = 0; j < cols; ++j) {
      std::vector<double> column(rows, 0.0);
      for (int i = 0; i < cols; ++i) column[i] = B.entries[i * cols + j];
      column = reflect(column);
      for (int i = 0; i < rows; ++i) A.entries[i * cols + j] = column[i];
    }
    std::vector<double> unreachable(rows, 0.0);
    for (int i = cols; i < rows; ++i) unreachable[i] = random.normal();
    unreachable = reflect(unreachable);
    const std::vector<double> x = random.normals(cols);
    std::vector<double> b = A.times(x);
    for (int i = 0; i < rows; ++i) b[i] += unreachable[i];
    // Rounding leaves A'Q[0; z] at u ||A|| ||z||, within the drift's allowance.
    expect_solves(trial, "least squares", A, b, x, 0.99);
  }
  // With fewer rows than columns A'A is singular, and any solution x passes. The first guess, A'b, is in its
  // range.
  for (auto [rows, cols] : {std::pair{2, 5}, {3, 40}}) {
    const Matrix A = random_table(random, rows, cols);
    std::vector<double> b = random.normals(rows);
    const double length = norm(A.transposed().times(b));
    for (double& value : b) value /= length;
    const NormalSolution solution = solve(trial, "fewer rows than columns", A, b, 1e-12, 0);
    trial.expect_at_most(normal_residual(A, solution.x, b),
                         1e-6 + drift(A, solution.x, A.transposed().times(b)), "the norm of A'(b - Ax)");
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
  std::vector<double> diagonal(n);
  for (double& value : diagonal) value = random.uniform(2, 20);
  const Matrix A = symmetric(dominant(random, diagonal));
  const std::vector<double> x = random.normals(n), b = A.times(x), Atb = A.transposed().times(b);
  expect_solves(trial, "ordinary", A, b, x, 1);
  // epsilon decides here: it is a little more than the residual after three steps, in a unit in which no
  // length is 1.
  std::vector<double> large = b;
  for (double& value : large) value *= 0x1p20;
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
