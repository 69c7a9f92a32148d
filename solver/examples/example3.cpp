// Example 3 of the lecture: A is not symmetric, or not positive definite. Solve A'A x = A'b instead, given
// products with A and with A'. The price, cond(A'A) = cond(A)^2, is in the study of `hairlab solver`.
#include <cstdio>

#include "solver/normal_equations.h"

namespace {

// Not symmetric.
class A3 : public implicitMatrix {
 public:
  void matVecMult(double x[], double b[]) override {
    b[0] = x[0] + 2 * x[1];
    b[1] = x[1] + 2 * x[2];
    b[2] = x[2];
  }
};

// The transpose of A3.
class A3Transposed : public implicitMatrix {
 public:
  void matVecMult(double x[], double b[]) override {
    b[0] = x[0];
    b[1] = 2 * x[0] + x[1];
    b[2] = 2 * x[1] + x[2];
  }
};

// Symmetric, so that it is its own transpose, but not positive definite: its eigenvalues are 4 and -2.
class A4 : public implicitMatrix {
 public:
  void matVecMult(double x[], double b[]) override {
    b[0] = x[0] + 3 * x[1];
    b[1] = 3 * x[0] + x[1];
  }
};

}  // namespace

int main() {
  A3 a3;
  A3Transposed a3_transposed;
  double x[3], b[3] = {5.0, 8.0, 3.0};
  int steps = 100;
  double err = solve_normal_equations(3, 3, &a3, &a3_transposed, x, b, 1.0e-20, &steps);
  std::printf("Not symmetric: solved in %i steps with error %f.\n", steps, err);
  std::printf("A3 * [%f %f %f]^T = [%f %f %f]^T.\n", x[0], x[1], x[2], b[0], b[1], b[2]);

  A4 a4;
  double y[2], c[2] = {7.0, 5.0};
  steps = 100;
  err = solve_normal_equations(2, 2, &a4, &a4, y, c, 1.0e-20, &steps);
  std::printf("Not positive definite: solved in %i steps with error %f.\n", steps, err);
  std::printf("A4 * [%f %f]^T = [%f %f]^T.\n", y[0], y[1], c[0], c[1]);
  return 0;
}
