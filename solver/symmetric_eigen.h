// Eigenvalues and eigenvectors of a symmetric matrix: Eigen's SelfAdjointEigenSolver, compiled once for all that needs it (three
// seconds for each file else).
#pragma once

#include <Eigen/Core>

namespace solver {

struct SymmetricEigen {
  Eigen::VectorXd values;   // n, ascending
  Eigen::MatrixXd vectors;  // n x n; column i belongs to values[i] and has length 1
};

// A: n x n; its lower triangle alone is read. Values are near the true ones to some roundings of ||A||.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

// The same values alone: n, ascending.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

// Of a symmetric tridiagonal matrix: its diagonal, n numbers, and what is beside it, n - 1.
Eigen::VectorXd tridiagonal_eigenvalues(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside);

}  // namespace solver
