// STAFF ONLY. A right S2 as the lecture writes its matrices, public virtual functions and arrays.
#include "solver/normal_equations.h"

#include "linearSolver.h"

class Dense : public implicitMatrix {
 public:
  Dense(int r, int c, const double a[]) {
    rows = r;
    cols = c;
    entries = new double[(size_t)rows * cols + 1];
    for (size_t k = 0; k < (size_t)rows * cols; k++) entries[k] = a[k];
  }
  Dense(const Dense&) = delete;
  ~Dense() { delete[] entries; }

  virtual void matVecMult(double x[], double b[]) {
    for (int i = 0; i < rows; i++) b[i] = 0.0;
    for (int j = 0; j < cols; j++)
      for (int i = 0; i < rows; i++) b[i] += entries[(size_t)i * cols + j] * x[j];
  }

 private:
  int rows, cols;
  double* entries;
};

class Normal : public implicitMatrix {
 public:
  Normal(int rows, implicitMatrix* matrix, implicitMatrix* transposed) {
    A = matrix;
    AT = transposed;
    Ax = new double[rows + 1];
  }
  Normal(const Normal&) = delete;
  ~Normal() { delete[] Ax; }

  virtual void matVecMult(double x[], double b[]) {
    A->matVecMult(x, Ax);
    AT->matVecMult(Ax, b);
  }

 private:
  implicitMatrix *A, *AT;
  double* Ax;
};

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  implicitMatrix* matrix = new Dense(rows, cols, a);
  return std::unique_ptr<implicitMatrix>(matrix);
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  implicitMatrix* matrix = new Normal(rows, A, A_transposed);
  return std::unique_ptr<implicitMatrix>(matrix);
}

// Then solve the normal equations
double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  implicitMatrix* matrix = new Normal(rows, A, A_transposed);
  double* ATb = new double[cols + 1];
  A_transposed->matVecMult(b, ATb);
  double err = ConjGrad(cols, matrix, x, ATb, epsilon, steps);
  delete[] ATb;
  delete matrix;
  return err;
}
