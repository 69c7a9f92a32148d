#include "solver/study/preconditioned.h"

#include <algorithm>
#include <cmath>

namespace solver::study {

namespace {

class PreconditionedMatrix : public implicitMatrix {
 public:
  PreconditionedMatrix(implicitMatrix& A, const BandedCholesky& near)
      : A_(A), near_(near), work_(near.size()) {}

  void matVecMult(double x[], double b[]) override {
    std::copy(x, x + work_.size(), work_.begin());
    near_.solve_lower_transposed(work_.data());
    A_.matVecMult(work_.data(), b);
    near_.solve_lower(b);
  }

 private:
  implicitMatrix& A_;
  const BandedCholesky& near_;
  Vector work_;
};

}  // namespace

ConjGradFunction preconditioned(const ConjGradFunction& solve, BandedCholesky& near) {
  return [&solve, &near](int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
    near.factor();
    PreconditionedMatrix matrix(*A, near);
    Vector right_side(b, b + n);
    near.solve_lower(right_side.data());
    solve(n, &matrix, x, right_side.data(), epsilon, steps);
    near.solve_lower_transposed(x);
    return std::nan("");
  };
}

}  // namespace solver::study
