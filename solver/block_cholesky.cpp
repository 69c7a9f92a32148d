#include "solver/block_cholesky.h"

#include <algorithm>
#include <cmath>

namespace solver {

double BlockBand::norm() const {
  double largest = 0;
  for (int i = 0; i < rows(); ++i)
    for (int row = 0; row < 3; ++row) {
      double sum = 0;
      for (int column = 0; column < 3; ++column)
        sum += std::abs(row >= column ? block(i, 0)(row, column) : block(i, 0)(column, row));
      for (int back = 1; back <= std::min(kReach, i); ++back) sum += block(i, back).row(row).cwiseAbs().sum();
      for (int below = 1; below <= std::min(kReach, rows() - 1 - i); ++below)
        sum += block(i + below, below).col(row).cwiseAbs().sum();
      largest = std::max(largest, sum);
    }
  return largest;
}

using Eigen::Matrix3d, Eigen::Vector3d;

namespace block_cholesky {

Vector3d divide(const Matrix3d& L, const Vector3d& b) {
  const double x = b[0] * L(0, 0);
  const double y = (b[1] - L(1, 0) * x) * L(1, 1);
  return {x, y, (b[2] - L(2, 0) * x - L(2, 1) * y) * L(2, 2)};
}

Vector3d divide_transposed(const Matrix3d& L, const Vector3d& b) {
  const double z = b[2] * L(2, 2);
  const double y = (b[1] - L(2, 1) * z) * L(1, 1);
  return {(b[0] - L(1, 0) * y - L(2, 0) * z) * L(0, 0), y, z};
}

bool factor(Matrix3d& A) {
  for (int j = 0; j < 3; ++j) {
    double pivot = A(j, j);
    for (int k = 0; k < j; ++k) pivot -= A(j, k) * A(j, k);
    if (!(pivot > 0) || !std::isfinite(pivot)) return false;
    A(j, j) = 1 / std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i) {
      for (int k = 0; k < j; ++k) A(i, j) -= A(i, k) * A(j, k);
      A(i, j) *= A(j, j);
    }
  }
  return true;
}

}  // namespace block_cholesky

namespace {

// A L^-T.
Matrix3d divide_right(const Matrix3d& A, const Matrix3d& L) {
  Matrix3d quotient;
  quotient.col(0) = A.col(0) * L(0, 0);
  quotient.col(1) = (A.col(1) - quotient.col(0) * L(1, 0)) * L(1, 1);
  quotient.col(2) = (A.col(2) - quotient.col(0) * L(2, 0) - quotient.col(1) * L(2, 1)) * L(2, 2);
  return quotient;
}

}  // namespace

bool cholesky(BlockBand& band) {
  for (int i = 0; i < band.rows(); ++i) {
    Matrix3d diagonal = band.block(i, 0);
    Matrix3d beside[BlockBand::kReach + 1];  // this row's blocks, by `back`
    for (int back = std::min(BlockBand::kReach, i); back > 0; --back) {
      Matrix3d block = band.block(i, back);
      for (int further = back + 1; further <= std::min(BlockBand::kReach, i); ++further)
        block.noalias() -= beside[further].lazyProduct(band.block(i - back, further - back).transpose());
      beside[back] = divide_right(block, band.block(i - back, 0));
      band.block(i, back) = beside[back];
      diagonal.noalias() -= beside[back].lazyProduct(beside[back].transpose());
    }
    if (!block_cholesky::factor(diagonal)) return false;
    band.block(i, 0) = diagonal;
  }
  return true;
}

void solve_lower(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x) {
  for (int i = 0; i < L.rows(); ++i) {
    Vector3d left = x.segment<3>(3 * i);
    for (int back = 1; back <= std::min(BlockBand::kReach, i); ++back)
      left.noalias() -= L.block(i, back) * x.segment<3>(3 * (i - back));
    x.segment<3>(3 * i) = block_cholesky::divide(L.block(i, 0), left);
  }
}

void solve_lower_transposed(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x) {
  for (int i = L.rows() - 1; i >= 0; --i) {
    const Vector3d solved = block_cholesky::divide_transposed(L.block(i, 0), x.segment<3>(3 * i));
    x.segment<3>(3 * i) = solved;
    for (int back = 1; back <= std::min(BlockBand::kReach, i); ++back)
      x.segment<3>(3 * (i - back)).noalias() -= L.block(i, back).transpose() * solved;
  }
}

}  // namespace solver
