// Example 3 of the lecture: A is not symmetric, or not positive definite. Solve A'A x = A'b instead, given
// products with A and with A'. The second part shows the price: cond(A'A) = cond(A)^2, and both the steps and
// the error of x grow with it.
#include <cmath>
#include <cstdio>
#include <vector>

#include "solver/matrices.h"
#include "solver/normal_equations.h"

namespace {

using Vector = std::vector<double>;

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

double norm(const Vector& x) {
  double squared = 0;
  for (double value : x) squared += value * value;
  return std::sqrt(squared);
}

// Numbers in (-1, 1) with no pattern.
Vector scattered(int n, unsigned seed) {
  Vector values(n);
  for (double& value : values) {
    seed = 1664525 * seed + 1013904223;
    value = seed / 2147483648.0 - 1;
  }
  return values;
}

struct Cost {
  int steps;
  double error;  // ||x - x*|| / ||x*||
};

constexpr double kTolerance = 1e-8;  // residual over right-hand side
constexpr int kMostSteps = 50000;

// A x = b by ConjGrad, or by the normal equations, for a symmetric, positive definite A and the solution
// `exact`.
Cost cost(solver::SpectralMatrix A, const Vector& exact, bool normal) {
  const int n = A.size();
  Vector x = exact, b(n), Ab(n);
  A.matVecMult(x.data(), b.data());
  A.matVecMult(b.data(), Ab.data());
  int steps = kMostSteps;
  if (normal)
    solve_normal_equations(n, n, &A, &A, x.data(), b.data(), std::pow(kTolerance * norm(Ab), 2), &steps);
  else
    ConjGrad(n, &A, x.data(), b.data(), std::pow(kTolerance * norm(b), 2), &steps);
  for (int i = 0; i < n; ++i) x[i] -= exact[i];
  return {steps, norm(x) / norm(exact)};
}

// ||r_k|| <= 2 sqrt(c) ((sqrt(c) - 1) / (sqrt(c) + 1))^k ||r_0|| for the condition number c, and
// ||r_0|| <= 2 ||b||, since ||A|| = 1. So ||r_k|| <= kTolerance ||b|| after about this many steps.
double most_steps(double c) {
  return std::ceil(std::sqrt(c) / 2 * std::log(4 * std::sqrt(c) / kTolerance));
}

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
  std::printf("A4 * [%f %f]^T = [%f %f]^T.\n\n", y[0], y[1], c[0], c[1]);

  const int n = 200;
  const std::vector<Vector> reflectors = {scattered(n, 1), scattered(n, 2)};
  const Vector exact = scattered(n, 3);
  std::printf(
      "What A'A costs: %d unknowns, eigenvalues from 1/c to 1 with evenly spaced logarithms, until the\n", n);
  std::printf("residual is %g of the right-hand side. In brackets what theory allows, without rounding:\n",
              kTolerance);
  std::printf("sqrt(C)/2 log(4 sqrt(C) / %g) steps and an error of C %g, where C = c or c^2.\n\n", kTolerance,
              kTolerance);
  std::printf("| %7s | %23s | %19s | %23s | %19s |\n", "c", "ConjGrad: steps", "its error of x", "A'A: steps",
              "its error of x");
  std::printf("|--:|--:|--:|--:|--:|\n");
  for (double condition : {1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8}) {
    const solver::SpectralMatrix A(solver::log_spaced(n, 1 / condition, 1), reflectors);
    std::printf("| %7.0e |", condition);
    for (bool normal : {false, true}) {
      const Cost measured = cost(A, exact, normal);
      const double c = normal ? condition * condition : condition;
      char text[40];
      std::snprintf(text, sizeof text, "%s%d (%.0f)", measured.steps == kMostSteps ? "not in " : "",
                    measured.steps, most_steps(c));
      std::printf(" %23s | %8.1e (%8.1e) |", text, measured.error, c * kTolerance);
    }
    std::printf("\n");
  }
  return 0;
}
