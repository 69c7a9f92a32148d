// Solves, determinants and eigenvalues of small dense matrices, for tests and studies. Eigen's solvers are
// compiled only here, because they cost some seconds for each file that includes them.
#pragma once

#include <Eigen/Core>

namespace solver {

// Returns X with A X = B, by Gaussian elimination with partial pivoting. A: n x n, not singular. B: n x m.
// The error is that of rounding, times the condition number of A.
Eigen::MatrixXd dense_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

// The sign -1, 0 or 1 of A's determinant, which may itself be too large or too small for a double.
int determinant_sign(const Eigen::MatrixXd& A);

// Eigenvalues and eigenvectors of a symmetric matrix by Eigen's SelfAdjointEigenSolver.
struct SymmetricEigen {
  Eigen::VectorXd values;   // n, ascending
  Eigen::MatrixXd vectors;  // n x n; column i belongs to values[i] and has length 1
};

// A: n x n; only its lower triangle is read. The values are correct up to a few roundings of ||A||.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

// The eigenvalues only: n, ascending.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

// The eigenvalues of a symmetric tridiagonal matrix with n numbers on the diagonal and n - 1 beside it.
Eigen::VectorXd tridiagonal_eigenvalues(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside);

}  // namespace solver
