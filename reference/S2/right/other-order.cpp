// STAFF ONLY. A right S2 in another order: the table is kept by columns, and a product adds up columns from
// the last to the first.
#include <vector>

#include "solver/normal_equations.h"

namespace {

struct Columns : implicitMatrix {
  Columns(int rows, int cols, const double a[]) : columns(cols, std::vector<double>(rows)), rows(rows) {
    for (int j = 0; j < cols; ++j)
      for (int i = 0; i < rows; ++i) columns[j][i] = a[static_cast<long>(i) * cols + j];
  }

  void matVecMult(double x[], double b[]) override {
    for (int i = 0; i < rows; ++i) b[i] = 0;
    for (int j = static_cast<int>(columns.size()); j-- > 0;)
      for (int i = 0; i < rows; ++i) b[i] += columns[j][i] * x[j];
  }

  std::vector<std::vector<double>> columns;
  int rows;
};

struct Twice : implicitMatrix {
  Twice(int rows, implicitMatrix* first, implicitMatrix* second)
      : between(rows), first(first), second(second) {}

  void matVecMult(double x[], double b[]) override {
    first->matVecMult(x, between.data());
    second->matVecMult(between.data(), b);
  }

  std::vector<double> between;
  implicitMatrix *first, *second;
};

}  // namespace

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  return std::unique_ptr<implicitMatrix>(new Columns(rows, cols, a));
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::unique_ptr<implicitMatrix>(new Twice(rows, A, A_transposed));
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  Twice operation(rows, A, A_transposed);
  std::vector<double> Atb(cols);
  A_transposed->matVecMult(b, Atb.data());
  const double error = ConjGrad(cols, &operation, x, Atb.data(), epsilon, steps);
  return error;
}
