#include "solver/dense_algebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace solver {

using Elimination = Eigen::PartialPivLU<Eigen::MatrixXd>;

Eigen::MatrixXd dense_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return Elimination(A).solve(B);
}

int determinant_sign(const Eigen::MatrixXd& A) {
  const Elimination factors(A);
  int sign = static_cast<int>(factors.permutationP().determinant());
  for (const double pivot : factors.matrixLU().diagonal()) sign *= pivot < 0 ? -1 : pivot > 0 ? 1 : 0;
  return sign;
}

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  const Solver solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A) {
  return Solver(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd tridiagonal_eigenvalues(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside) {
  Solver solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return solver.eigenvalues();
}

}  // namespace solver
