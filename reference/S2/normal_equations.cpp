// STAFF ONLY. S2: the normal equations.

#include "solver/normal_equations.h"

#include <cstddef>
#include <vector>

namespace {

class DenseMatrix : public implicitMatrix {
 public:
  DenseMatrix(int rows, int cols, const double a[])
      : rows_(rows), cols_(cols), entries_(a, a + static_cast<std::size_t>(rows) * cols) {}

  void matVecMult(double x[], double b[]) override {
    const double* row = entries_.data();
    for (int i = 0; i < rows_; ++i, row += cols_) {
      double sum = 0;
      for (int j = 0; j < cols_; ++j) sum += row[j] * x[j];
      b[i] = sum;
    }
  }

 private:
  int rows_, cols_;
  std::vector<double> entries_;
};

class NormalMatrix : public implicitMatrix {
 public:
  NormalMatrix(int rows, implicitMatrix* A, implicitMatrix* A_transposed)
      : A_(A), A_transposed_(A_transposed), Ax_(rows) {}

  void matVecMult(double x[], double b[]) override {
    A_->matVecMult(x, Ax_.data());
    A_transposed_->matVecMult(Ax_.data(), b);
  }

 private:
  implicitMatrix *A_, *A_transposed_;
  std::vector<double> Ax_;
};

}  // namespace

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  return std::make_unique<DenseMatrix>(rows, cols, a);
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int /*cols*/, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::make_unique<NormalMatrix>(rows, A, A_transposed);
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  std::vector<double> Atb(cols);
  A_transposed->matVecMult(b, Atb.data());
  NormalMatrix AtA(rows, A, A_transposed);
  return ConjGrad(cols, &AtA, x, Atb.data(), epsilon, steps);
}
