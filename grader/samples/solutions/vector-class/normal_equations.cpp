// STAFF ONLY. A right S2 with lambdas: one class stands for every operator.
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "solver/normal_equations.h"

namespace {

using Product = std::function<void(double*, double*)>;

class Operator final : public implicitMatrix {
 public:
  explicit Operator(Product product) : product_(std::move(product)) {}
  void matVecMult(double x[], double b[]) override { product_(x, b); }

 private:
  Product product_;
};

}  // namespace

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  std::vector<std::vector<double>> table;
  for (int i = 0; i < rows; ++i) table.emplace_back(a + long(i) * cols, a + long(i + 1) * cols);
  return std::make_unique<Operator>([table = std::move(table)](double* x, double* b) {
    for (const auto& row : table) *b++ = std::inner_product(row.begin(), row.end(), x, 0.0);
  });
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int /*cols*/, implicitMatrix* A, implicitMatrix* At) {
  return std::make_unique<Operator>([A, At, Ax = std::vector<double>(rows)](double* x, double* b) mutable {
    A->matVecMult(x, Ax.data());
    At->matVecMult(Ax.data(), b);
  });
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  std::vector<double> c(cols);
  A_transposed->matVecMult(b, c.data());
  return ConjGrad(cols, normal_matrix(rows, cols, A, A_transposed).get(), x, c.data(), epsilon, steps);
}
