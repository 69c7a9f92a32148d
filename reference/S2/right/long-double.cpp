// STAFF ONLY. A right S2 that adds rows up in long double.
#include "solver/normal_equations.h"

#include <numeric>
#include <vector>

namespace {

struct Table : implicitMatrix {
  int rows, cols;
  std::vector<double> entries;

  Table(int r, int c, const double* a) : rows(r), cols(c), entries(a, a + static_cast<long>(r) * c) {}

  void matVecMult(double x[], double b[]) override {
    auto entry = entries.begin();
    for (int i = 0; i < rows; ++i, entry += cols)
      b[i] = static_cast<double>(std::inner_product(entry, entry + cols, x, 0.0L));
  }
};

struct Squared : implicitMatrix {
  implicitMatrix &A, &At;
  std::vector<double> between;

  Squared(int rows, implicitMatrix& matrix, implicitMatrix& transposed)
      : A(matrix), At(transposed), between(rows) {}

  void matVecMult(double x[], double b[]) override {
    A.matVecMult(x, between.data());
    At.matVecMult(between.data(), b);
  }
};

}  // namespace

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  return std::unique_ptr<implicitMatrix>(new Table(rows, cols, a));
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::unique_ptr<implicitMatrix>(new Squared(rows, *A, *A_transposed));
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  Squared matrix(rows, *A, *A_transposed);
  std::vector<double> right(cols);
  A_transposed->matVecMult(b, right.data());
  return ConjGrad(cols, &matrix, x, right.data(), epsilon, steps);
}
