// STAFF ONLY. Calls ConjGrad for the tests, with vectors by value. It counts and watches the products, and
// spoils one if asked to.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/test_numbers.h"

namespace reference_tests {

using Vector = std::vector<double>;

// A matrix as a function from x to b.
class Matrix : public implicitMatrix {
 public:
  explicit Matrix(std::function<void(const double* x, double* b)> product) : product_(std::move(product)) {}
  void matVecMult(double x[], double b[]) override { product_(x, b); }

 private:
  std::function<void(const double* x, double* b)> product_;
};

// Counts the products of another matrix. The `spoilt`th (from 1) has `value` in place `at`.
class Watched : public implicitMatrix {
 public:
  explicit Watched(implicitMatrix& A, int spoilt = 0, double value = kNaN, int at = 0)
      : A_(A), spoilt_(spoilt), value_(value), at_(at) {}

  void matVecMult(double x[], double b[]) override {
    A_.matVecMult(x, b);
    if (++products == spoilt_) b[at_] = value_;
  }

  int products = 0;

 private:
  implicitMatrix& A_;
  int spoilt_;
  double value_;
  int at_;
};

struct Solution {
  Vector x;
  double squared_residual;
  int steps, products;
  Vector b;  // as ConjGrad left it
};

inline Solution solve(implicitMatrix& A, Vector b, double epsilon, int steps, double junk = -12345) {
  Watched watched(A);
  Vector x(b.size(), junk);
  const double rr = ConjGrad(static_cast<int>(b.size()), &watched, x.data(), b.data(), epsilon, &steps);
  return {x, rr, steps, watched.products, b};
}

inline double norm(const Vector& x) {
  long double squared = 0;
  for (double v : x) squared += static_cast<long double>(v) * v;
  return static_cast<double>(std::sqrt(squared));
}

inline Vector difference(const Vector& x, const Vector& y) {
  Vector d(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) d[i] = x[i] - y[i];
  return d;
}

inline bool all_finite(const Vector& x) {
  for (double v : x)
    if (!std::isfinite(v)) return false;
  return true;
}

// Numbers in (-1, 1) with no pattern, the same everywhere.
inline Vector scattered(int n, unsigned seed = 1) {
  Vector values(n);
  for (double& v : values) v = static_cast<int>(seed = 1664525 * seed + 1013904223) * 0x1p-31;
  return values;
}

}  // namespace reference_tests
