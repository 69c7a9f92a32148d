// STAFF ONLY. A right S2 by recursion: a row's product is that of its two halves.
#include "solver/normal_equations.h"

#include <functional>
#include <vector>

namespace {

double row_times(const double* row, const double* x, int count) {
  if (count == 0) return 0;
  if (count == 1) return *row * *x;
  return row_times(row, x, count / 2) + row_times(row + count / 2, x + count / 2, count - count / 2);
}

class ByFunction : public implicitMatrix {
 public:
  explicit ByFunction(std::function<void(double*, double*)> product) : product_(std::move(product)) {}
  void matVecMult(double x[], double b[]) override { product_(x, b); }

 private:
  std::function<void(double*, double*)> product_;
};

}  // namespace

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  const std::vector<double> table(a, a + static_cast<std::size_t>(rows) * cols);
  return std::make_unique<ByFunction>([rows, cols, table](double* x, double* b) {
    for (int i = rows - 1; i >= 0; --i) b[i] = row_times(&table[static_cast<std::size_t>(i) * cols], x, cols);
  });
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::make_unique<ByFunction>(
      [A, A_transposed, Ax = std::vector<double>(rows)](double* x, double* b) mutable {
        A->matVecMult(x, Ax.data());
        A_transposed->matVecMult(Ax.data(), b);
      });
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  const auto AtA = normal_matrix(rows, cols, A, A_transposed);
  std::vector<double> Atb(cols);
  A_transposed->matVecMult(b, Atb.data());
  return ConjGrad(cols, AtA.get(), x, Atb.data(), epsilon, steps);
}
