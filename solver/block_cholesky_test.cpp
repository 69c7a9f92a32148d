// STAFF ONLY. The promises of solver/block_band.h and solver/block_cholesky.h.
#include "solver/block_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>

#include "solver/test_numbers.h"

namespace solver {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

using reference_tests::kUnit;

// n blocks; B B' of a band B, so that it is positive definite, plus `shift` on the diagonal.
MatrixXd banded(int n, double shift, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd B = MatrixXd::Zero(3 * n, 3 * n);
  for (int i = 0; i < 3 * n; ++i)
    for (int j = std::max(0, 3 * (i / 3 - 2)); j <= i; ++j) B(i, j) = normal(random);
  return B * B.transpose() + shift * MatrixXd::Identity(3 * n, 3 * n);
}

// A's lower half in `memory`; numbers outside of all blocks are NaN.
void store(const MatrixXd& A, MatrixXd& memory) {
  memory.setConstant(A.rows(), BlockBand::kColumns, std::numeric_limits<double>::quiet_NaN());
  BlockBand band(memory);
  for (int i = 0; i < band.rows(); ++i)
    for (int back = 0; back <= std::min(i, BlockBand::kReach); ++back)
      band.block(i, back) = A.block<3, 3>(3 * i, 3 * (i - back));
}

TEST(BlockBand, NormIsTheLargestSumOfARow) {
  for (int n : {1, 2, 3, 9}) {
    const MatrixXd A = banded(n, 1, n);
    MatrixXd memory;
    store(A, memory);
    EXPECT_NEAR(BlockBand(memory).norm(), A.cwiseAbs().rowwise().sum().maxCoeff(), 30 * kUnit * A.norm());
    EXPECT_GE(BlockBand(memory).norm(), A.operatorNorm());
  }
}

TEST(BlockCholesky, FactorsTheBand) {
  for (int n : {1, 2, 3, 4, 20}) {
    const MatrixXd A = banded(n, 1e-3, 10 + n);
    MatrixXd memory;
    store(A, memory);
    BlockBand band(memory);
    ASSERT_TRUE(cholesky(band));
    MatrixXd L = MatrixXd::Zero(3 * n, 3 * n);
    for (int i = 0; i < n; ++i)
      for (int back = 0; back <= std::min(i, 2); ++back)
        L.block<3, 3>(3 * i, 3 * (i - back)) = band.block(i, back);
    L = L.triangularView<Eigen::Lower>().toDenseMatrix();
    L.diagonal() = L.diagonal().cwiseInverse();
    const MatrixXd allowed = 10 * kUnit * L.cwiseAbs() * L.cwiseAbs().transpose();
    EXPECT_TRUE(((L * L.transpose() - A).cwiseAbs().array() <= allowed.array()).all()) << n << " blocks";
  }
}

TEST(BlockCholesky, SolvesWithASmallBackwardError) {
  for (int n : {1, 2, 5, 60})
    for (double shift : {1e-8, 1e-3, 1.0}) {
      const MatrixXd A = banded(n, shift, 20 + n);
      MatrixXd memory;
      store(A, memory);
      BlockBand band(memory);
      ASSERT_TRUE(cholesky(band));
      const VectorXd b = VectorXd::LinSpaced(3 * n, -1, 2);
      VectorXd x = b;
      solve_lower(band, x);
      const double after_first = x.squaredNorm();
      solve_lower_transposed(band, x);
      // |E| <= 10 u |L| |L'|, whose numbers are at most those of A's diagonal: 15 in a row.
      EXPECT_LE((b - A * x).norm(), (10 + 15) * kUnit * 15 * A.diagonal().maxCoeff() * x.norm());
      // b . x = |L^-1 b|^2
      EXPECT_NEAR(b.dot(x), after_first, 1e-6 * after_first);
    }
}

TEST(BlockCholesky, RefusesWhatIsNotPositiveDefinite) {
  for (int bad : {0, 7, 14}) {
    MatrixXd A = banded(5, 1, 3), memory;
    A(bad, bad) = -1e-12;
    store(A, memory);
    BlockBand band(memory);
    EXPECT_FALSE(cholesky(band)) << "a pivot < 0 in row " << bad;
    A(bad, bad) = std::numeric_limits<double>::quiet_NaN();
    store(A, memory);
    EXPECT_FALSE(cholesky(band)) << "NaN in row " << bad;
    A(bad, bad) = std::numeric_limits<double>::infinity();
    store(A, memory);
    EXPECT_FALSE(cholesky(band)) << "infinity in row " << bad;
  }
}

}  // namespace
}  // namespace solver
