#include "solver/matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>

#include "solver/matrix_market.h"
#include "solver/test_comma_locale.h"
#include "solver/test_numbers.h"
#include "solver/test_refusal.h"

namespace solver {
namespace {

using reference_tests::kUnit;
constexpr double kPi = std::numbers::pi;

using Vector = std::vector<double>;

// x and b at once, and b full of NaN before, so that a missing write shows.
Vector product(implicitMatrix& A, Vector x, int rows) {
  Vector b(rows, NAN);
  A.matVecMult(x.data(), b.data());
  return b;
}

Vector random_vector(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vector values(n);
  for (double& v : values) v = uniform(random);
  return values;
}

double dot(const Vector& x, const Vector& y) {
  return std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
}

double norm(const Vector& x) {
  return std::sqrt(dot(x, x));
}

// ||A v - lambda v|| is rounding: of the product (its longest row's terms), of v's values (sines, 2 u each)
// and of lambda.
void expect_eigenpair(SparseMatrix A, const Vector& v, double lambda) {
  const Vector Av = product(A, v, A.rows());
  double squared = 0;
  for (int i = 0; i < A.rows(); ++i) squared += (Av[i] - lambda * v[i]) * (Av[i] - lambda * v[i]);
  EXPECT_LE(std::sqrt(squared), (A.longest_row() + 8) * kUnit * A.norm_bound() * norm(v))
      << "lambda = " << lambda;
}

void expect_symmetric(const SparseMatrix& A) {
  const auto entries = A.entries(), flipped = A.transposed().entries();
  ASSERT_EQ(entries.size(), flipped.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    EXPECT_EQ(entries[k].row, flipped[k].row);
    EXPECT_EQ(entries[k].col, flipped[k].col);
    EXPECT_EQ(entries[k].value, flipped[k].value) << "(" << entries[k].row << ", " << entries[k].col << ")";
  }
}

// Cholesky's pivots, all > 0 exactly if A is positive definite (up to rounding, which these matrices are far
// from).
double smallest_pivot(const SparseMatrix& A) {
  const int n = A.rows();
  std::vector<Vector> a(n, Vector(n, 0.0));
  for (const auto& e : A.entries()) a[e.row][e.col] = e.value;
  double smallest = INFINITY;
  for (int k = 0; k < n; ++k) {
    smallest = std::min(smallest, a[k][k]);
    for (int i = k + 1; i < n; ++i)
      for (int j = k + 1; j < n; ++j) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
  }
  return smallest;
}

TEST(SparseMatrix, AddsEntriesForOnePlaceUp) {
  SparseMatrix A(2, 3, {{1, 2, 4}, {0, 0, 1}, {1, 2, 0.5}, {1, 0, -1}, {0, 0, 2}});
  ASSERT_EQ(A.entries().size(), 3u);
  EXPECT_EQ(product(A, {1, 10, 100}, 2), (Vector{3, 449}));
  EXPECT_EQ(A.longest_row(), 2);
}

TEST(SparseMatrix, ListsItsEntriesByRowsThenColumns) {
  const SparseMatrix A(3, 3, {{2, 1, 6}, {2, 0, 5}, {0, 2, 1}, {1, 1, 2}});
  const auto entries = A.entries();
  ASSERT_EQ(entries.size(), 4u);
  for (std::size_t k = 1; k < entries.size(); ++k)
    EXPECT_LT(3 * entries[k - 1].row + entries[k - 1].col, 3 * entries[k].row + entries[k].col);
}

TEST(SparseMatrix, RefusesWhatIsOutside) {
  const std::vector<SparseMatrix::Entry> outside = {{-1, 0, 1}, {0, -1, 1}, {2, 0, 1}, {0, 3, 1}};
  for (const auto& e : outside)
    EXPECT_THROW(SparseMatrix(2, 3, {e}), std::invalid_argument) << e.row << ", " << e.col;
  EXPECT_THROW(SparseMatrix(-1, 3, {}), std::invalid_argument);
  EXPECT_THROW(SparseMatrix(3, -1, {}), std::invalid_argument);
  EXPECT_THROW(poisson_2d(-1), std::invalid_argument);
  EXPECT_THROW(poisson_2d(46341), std::invalid_argument);
}

TEST(SparseMatrix, MayBeEmpty) {
  SparseMatrix A(0, 0, {}), B(2, 0, {});
  EXPECT_EQ(A.rows(), 0);
  EXPECT_EQ(A.norm_bound(), 0);
  EXPECT_EQ(product(A, {}, 0), Vector{});
  EXPECT_EQ(product(B, {}, 2), (Vector{0, 0}));
}

TEST(SparseMatrix, TransposeMovesToTheOtherSideOfAProduct) {  // y'(A x) = (A'y)'x
  std::vector<SparseMatrix::Entry> entries;
  std::mt19937 random(1);
  for (int k = 0; k < 60; ++k)
    entries.push_back({static_cast<int>(random() % 7), static_cast<int>(random() % 11), random() / 4e9});
  SparseMatrix A(7, 11, entries), At = A.transposed();
  ASSERT_EQ(At.rows(), 11);
  ASSERT_EQ(At.cols(), 7);
  const Vector x = random_vector(11, 2), y = random_vector(7, 3);
  // 7 * 11 terms, each rounded at most 7 + 11 times
  EXPECT_NEAR(dot(y, product(A, x, 7)), dot(product(At, y, 11), x), 77 * 18 * kUnit * A.norm_bound());
}

TEST(SparseMatrix, NormBoundIsAboveTheNorm) {
  for (SparseMatrix A :
       {tridiagonal(20, 2, -1), poisson_2d(5), hilbert(6), SparseMatrix(2, 2, {{0, 1, 3}})}) {
    Vector x = random_vector(A.rows(), 4);
    for (int k = 0; k < 100; ++k) {  // the power method: from below
      const Vector y = product(A, x, A.rows());
      EXPECT_LE(norm(y), A.norm_bound() * norm(x) * (1 + 50 * kUnit));
      if (norm(y) == 0) break;
      x = y;
      const double length = norm(x);
      for (double& v : x) v /= length;
    }
  }
}

TEST(Diagonal, MultipliesEachValue) {
  SparseMatrix A = diagonal({2, -3, 0});
  EXPECT_EQ(product(A, {1, 10, 100}, 3), (Vector{2, -30, 0}));
}

TEST(Tridiagonal, HasTheEigenvaluesOfTheFormula) {
  for (int n : {1, 2, 3, 20}) {
    for (int k = 1; k <= n; ++k) {
      Vector v(n);
      for (int i = 0; i < n; ++i) v[i] = std::sin((i + 1) * k * kPi / (n + 1));
      expect_eigenpair(tridiagonal(n, 3, -1.25), v, 3 - 2.5 * std::cos(k * kPi / (n + 1)));
    }
    expect_symmetric(tridiagonal(n, 3, -1.25));
  }
}

TEST(Poisson2d, HasTheEigenvaluesOfTheFormula) {
  const int n = 6;
  for (int p = 1; p <= n; ++p)
    for (int q = 1; q <= n; ++q) {
      Vector v(n * n);
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          v[j * n + i] = std::sin((i + 1) * p * kPi / (n + 1)) * std::sin((j + 1) * q * kPi / (n + 1));
      expect_eigenpair(poisson_2d(n), v,
                       4 - 2 * std::cos(p * kPi / (n + 1)) - 2 * std::cos(q * kPi / (n + 1)));
    }
  expect_symmetric(poisson_2d(n));
}

TEST(Hilbert, IsSymmetricAndHasTheDeterminantOfTheFormula) {
  expect_symmetric(hilbert(12));
  // The product of Cholesky's pivots is det H(n) = c(n)^4 / c(2n), c(n) = 1! 2! ... (n-1)!: 1/6048000 for n =
  // 4; the last pivot is 1 / (H^-1)_nn, which is ((2n-2)!)^2 (2n-1) / (n-1)!^4 = 2800 for n = 4 (Choi, Amer.
  // Math. Monthly 90, 1983). cond(H(4)) = 1.6e4 magnifies rounding.
  EXPECT_NEAR(smallest_pivot(hilbert(4)), 1.0 / 2800, 1.6e4 * 16 * kUnit / 2800);
}

TEST(StrandImplicitEuler, IsSymmetricPositiveDefiniteFromLightToHeavy) {
  for (double mass : {1e-8, 1.0})
    for (double stiffness : {1.0, 1e6}) {
      const SparseMatrix A = strand_implicit_euler(Vector(10, mass), stiffness, 1e-3, 1e-3);
      ASSERT_EQ(A.rows(), 30);
      expect_symmetric(A);
      EXPECT_GT(smallest_pivot(A), 0) << "mass " << mass << ", stiffness " << stiffness;
    }
}

TEST(StrandImplicitEuler, MovesAFreeStrandByItsMassAndAStretchedOneByItsSprings) {
  const double h = 0.5, k = 3, k_bend = 7;
  SparseMatrix A = strand_implicit_euler({1, 2, 4}, k, k_bend, h);
  // Moving all particles as one stretches the first spring alone.
  EXPECT_EQ(product(A, {0, 0, 1, 0, 0, 1, 0, 0, 1}, 9), (Vector{0, 0, 1 + h * h * k, 0, 0, 2, 0, 0, 4}));
  EXPECT_EQ(product(A, {1, 0, 0, 1, 0, 0, 1, 0, 0}, 9), (Vector{1 + h * h * k_bend, 0, 0, 2, 0, 0, 4, 0, 0}));
  // Moving the last one alone pulls its upper neighbour.
  EXPECT_EQ(product(A, {0, 0, 0, 0, 0, 0, 0, 1, 0}, 9),
            (Vector{0, 0, 0, 0, -h * h * k_bend, 0, 0, 4 + h * h * k_bend, 0}));
}

TEST(SpectralMatrix, HasTheSpectrumWantedAndIsSymmetric) {
  const int n = 12;
  const Vector spectrum = log_spaced(n, 1e-6, 1);
  const std::vector<Vector> reflectors = {random_vector(n, 5), random_vector(n, 6), random_vector(n, 7)};
  SpectralMatrix A(spectrum, reflectors);
  for (int k = 0; k < n; ++k) {  // its eigenvectors are Q's columns, Q e_k
    Vector v(n, 0.0);
    v[k] = 1;
    for (const Vector& w : reflectors) {
      const double scale = 2 * dot(w, v) / dot(w, w);
      for (int i = 0; i < n; ++i) v[i] -= scale * w[i];
    }
    const Vector Av = product(A, v, n);
    // 7 reflections of n terms each round; ||A|| = 1
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(Av[i], spectrum[k] * v[i], 7 * 4 * n * kUnit) << "eigenvalue " << k;
  }
  const Vector x = random_vector(n, 8), y = random_vector(n, 9);
  EXPECT_NEAR(dot(y, product(A, x, n)), dot(x, product(A, y, n)), 2 * 7 * 4 * n * kUnit * norm(x) * norm(y));
}

TEST(SpectralMatrix, RefusesReflectorsWithoutSizeOrDirection) {
  EXPECT_THROW(SpectralMatrix({1, 2}, {{1}}), std::invalid_argument);
  EXPECT_THROW(SpectralMatrix({1, 2}, {{0, 0}}), std::invalid_argument);
  EXPECT_THROW(SpectralMatrix({1, 2}, {{NAN, 0}}), std::invalid_argument);
}

TEST(LogSpaced, GoesFromLowToHighInEqualRatios) {
  const Vector v = log_spaced(9, 1e-4, 1e4);
  EXPECT_DOUBLE_EQ(v.front(), 1e-4);
  EXPECT_DOUBLE_EQ(v.back(), 1e4);
  for (std::size_t i = 1; i < v.size(); ++i) EXPECT_NEAR(v[i] / v[i - 1], 10, 1e-13);
  EXPECT_THROW(log_spaced(1, 1, 2), std::invalid_argument);
  EXPECT_THROW(log_spaced(2, 0, 2), std::invalid_argument);
  EXPECT_THROW(log_spaced(2, 3, 2), std::invalid_argument);
  EXPECT_THROW(log_spaced(2, 1, NAN), std::invalid_argument);
}

// A file with this text.
std::string file_of(const std::string& text) {
  const std::string path = testing::TempDir() + "/hair_matrix_market_test.mtx";
  std::ofstream(path) << text;
  return path;
}

// In a locale with a decimal comma, too.
TEST(MatrixMarket, ReadsBackWhatItWroteBitByBit) {
  const CommaLocale comma(testing::TempDir());
  const Vector hard = {
      1.0 / 3, -0.1, 2e-308, 1.7976931348623157e308, 2.2250738585072014e-308, 0x1.fffffffffffffp-1,
      -0.0,    1e-8};
  std::vector<SparseMatrix::Entry> entries;
  for (int k = 0; k < 8; ++k) entries.push_back({k % 3, 1000 * k, hard[k]});
  std::ostringstream matrix, vector;
  write_matrix_market(matrix, SparseMatrix(3, 8000, entries));
  EXPECT_TRUE(matrix.str().starts_with(
      "%%MatrixMarket matrix coordinate real general\n3 8000 8\n1 1 0.33333333333333331\n"))
      << matrix.str();
  const SparseMatrix back = read_matrix_market(file_of(matrix.str()));
  EXPECT_EQ(back.rows(), 3);
  EXPECT_EQ(back.cols(), 8000);
  ASSERT_EQ(back.entries().size(), 8u);
  for (const auto& e : back.entries())
    EXPECT_EQ(std::memcmp(&e.value, &hard[e.col / 1000], 8), 0) << hard[e.col / 1000];

  write_vector(vector, hard);
  const Vector values = read_vector(file_of(vector.str()));
  ASSERT_EQ(values.size(), hard.size());
  EXPECT_EQ(std::memcmp(values.data(), hard.data(), 8 * hard.size()), 0);
}

TEST(MatrixMarket, RefusesFilesThatItDidNotWrite) {
  const std::string matrix = "%%MatrixMarket matrix coordinate real general\n",
                    vector = "%%MatrixMarket matrix array real general\n";
  for (const std::string& text :
       {std::string(), vector + "1 1\n1\n", matrix + "2 2\n", matrix + "2 2 2\n1 1 1\n",
        matrix + "2 2 1\n3 1 1\n", matrix + "2 2 1\n1 1 nan\n", matrix + "1 1 1\n1 1 1,5\n",
        matrix + "1 1 1\n1 1 1\n1 1 1\n"})
    EXPECT_THROW(read_matrix_market(file_of(text)), std::invalid_argument) << text;
  for (const std::string& text : {matrix + "1 1 1\n1 1 1\n", vector + "1 2\n1\n2\n", vector + "2 1\n1\n",
                                  vector + "1 1\n1\n2\n", vector + "1 1\nx\n"})
    EXPECT_THROW(read_vector(file_of(text)), std::invalid_argument) << text;
  EXPECT_EQ(tests::refusal<std::invalid_argument>([] { read_vector("/nonexistent/b.mtx"); }),
            "/nonexistent/b.mtx: it does not begin with %%MatrixMarket matrix array real general; restore it "
            "from the handout");
}

}  // namespace
}  // namespace solver
