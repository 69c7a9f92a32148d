// STAFF ONLY. A right S2 that keeps its table by columns: a product is a sum of columns, x_j of each.
#include "solver/normal_equations.h"

#include <algorithm>
#include <valarray>
#include <vector>

namespace {

class Columns : public implicitMatrix {
 public:
  Columns(int rows, int cols, const double a[]) : sum_(rows) {
    for (int j = 0; j < cols; ++j) {
      columns_.emplace_back(rows);
      for (int i = 0; i < rows; ++i) columns_.back()[i] = a[static_cast<long>(i) * cols + j];
    }
  }

  void matVecMult(double x[], double b[]) override {
    sum_ = 0;
    for (std::size_t j = columns_.size(); j-- > 0;) sum_ += x[j] * columns_[j];
    std::copy(std::begin(sum_), std::end(sum_), b);
  }

 private:
  std::vector<std::valarray<double>> columns_;
  std::valarray<double> sum_;
};

class Chain : public implicitMatrix {
 public:
  Chain(int rows, implicitMatrix* first, implicitMatrix* second)
      : first_(first), second_(second), middle_(rows) {}

  void matVecMult(double x[], double b[]) override {
    first_->matVecMult(x, &middle_[0]);
    second_->matVecMult(&middle_[0], b);
  }

 private:
  implicitMatrix *first_, *second_;
  std::valarray<double> middle_;
};

}  // namespace

std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]) {
  return std::make_unique<Columns>(rows, cols, a);
}

std::unique_ptr<implicitMatrix> normal_matrix(int rows, int, implicitMatrix* A,
                                              implicitMatrix* A_transposed) {
  return std::make_unique<Chain>(std::max(rows, 1), A, A_transposed);
}

double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps) {
  Chain chain(std::max(rows, 1), A, A_transposed);
  std::valarray<double> right(std::max(cols, 1));
  A_transposed->matVecMult(b, &right[0]);
  return ConjGrad(cols, &chain, x, &right[0], epsilon, steps);
}
