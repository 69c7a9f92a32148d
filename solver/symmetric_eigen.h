// Eigenvalues and eigenvectors of a symmetric matrix by Eigen's SelfAdjointEigenSolver. It is compiled only
// here, because it costs three seconds for each file that includes it.
#pragma once

#include <Eigen/Core>

namespace solver {

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
