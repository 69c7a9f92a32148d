#include "solver/dense_solve.h"

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

}  // namespace solver
