// STAFF ONLY. A right S2 whose helpers have external linkage and take names that other files of the class
// use, too. `dot` and `axpy` mean something else here than in this folder's S1.
#include <cstring>
#include <vector>

#include "solver/normal_equations.h"

// sum = sum + a'b
void dot(int n, const double* a, const double* b, double& sum) {
  for (int i = 0; i < n; ++i) sum += a[i] * b[i];
}

// b = A'x
double axpy(implicitMatrix* A_transposed, double* x, double* b) {
  A_transposed->matVecMult(x, b);
  return b ? 1 : 0;
}

class DenseMatrix : public implicitMatrix {
 public:
  DenseMatrix(int rows, int cols, const double* a)
      : rows_(rows), cols_(cols), a_(new double[std::size_t(rows) * cols]) {
    if (rows > 0 && cols > 0) std::memcpy(a_, a, sizeof(double) * rows * cols);
  }
  ~DenseMatrix() override { delete[] a_; }
  DenseMatrix(const DenseMatrix&) = delete;
  DenseMatrix& operator=(const DenseMatrix&) = delete;

  void matVecMult(double x[], double b[]) override {
    for (int i = 0; i < rows_; ++i) {
      double sum = 0;
      dot(cols_, a_ + std::size_t(i) * cols_, x, sum);
      b[i] = sum;
    }
  }

 private:
  int rows_, cols_;
  double* a_;
};

class NormalMatrix : public implicitMatrix {
 public:
  NormalMatrix(int rows, implicitMatrix* A, implicitMatrix* A_transposed)
      : first_(A), second_(A_transposed), Ax_(rows) {}
  void matVecMult(double x[], double b[]) override {
    first_->matVecMult(x, Ax_.data());
    second_->matVecMult(Ax_.data(), b);
  }

 private:
  implicitMatrix *first_, *second_;
  std::vector<double> Ax_;
};

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  return std::make_unique<DenseMatrix>(rows, cols, a);
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::make_unique<NormalMatrix>(rows, A, A_transposed);
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  std::vector<double> Atb(cols);
  axpy(A_transposed, b, Atb.data());
  NormalMatrix AtA(rows, A, A_transposed);
  return ConjGrad(cols, &AtA, x, Atb.data(), epsilon, steps);
}
