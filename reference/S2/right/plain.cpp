// STAFF ONLY. A right S2, straight from the formulas. The patches for S2 apply to it.
#include <vector>

#include "solver/normal_equations.h"

using std::vector;

class Dense : public implicitMatrix {
 public:
  Dense(int rows, int cols, const double a[]) : rows(rows), cols(cols) {
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < cols; ++j) entries.push_back(a[i * cols + j]);
  }

  void matVecMult(double x[], double b[]) override {
    for (int i = 0; i < rows; ++i) {
      b[i] = 0;
      for (int j = 0; j < cols; ++j) b[i] += entries[i * cols + j] * x[j];
    }
  }

 private:
  int rows, cols;
  vector<double> entries;
};

class Normal : public implicitMatrix {
 public:
  Normal(int rows, implicitMatrix* A, implicitMatrix* A_transposed)
      : A(A), A_transposed(A_transposed), product(rows) {}

  void matVecMult(double x[], double b[]) override {
    A->matVecMult(x, product.data());
    A_transposed->matVecMult(product.data(), b);
  }

 private:
  implicitMatrix* A;
  implicitMatrix* A_transposed;
  vector<double> product;
};

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  return std::make_unique<Dense>(rows, cols, a);
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int /*cols*/, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::make_unique<Normal>(rows, A, A_transposed);
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  // A'A x = A'b
  vector<double> right_side(cols);
  A_transposed->matVecMult(b, right_side.data());
  auto AtA = normal_matrix(rows, cols, A, A_transposed);
  return ConjGrad(cols, AtA.get(), x, right_side.data(), epsilon, steps);
}
