// A X = B for small dense matrices of tests and studies, by Eigen's Gaussian elimination with partial
// pivoting. It is compiled only here, because it costs some seconds for each file that includes it.
#pragma once

#include <Eigen/Core>

namespace solver {

// A: n x n, not singular. B: n x m. The error is that of rounding, times the condition number of A.
Eigen::MatrixXd dense_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

// The sign -1, 0 or 1 of A's determinant, which may itself be too large or too small for a double.
int determinant_sign(const Eigen::MatrixXd& A);

}  // namespace solver
