// STAFF ONLY. A right S1 with a vector class of its own, in which the algorithm reads like the formulas. Dot
// products add up pairwise.
#include <cmath>
#include <memory>
#include <utility>

#include "solver/linearSolver.h"

namespace {

class Vector {
 public:
  explicit Vector(int size) : size_(size), data_(new double[size]()) {}
  Vector(int size, const double* from) : Vector(size) {
    for (int i = 0; i < size; ++i) data_[i] = from[i];
  }
  Vector(const Vector& other) : Vector(other.size_, other.data()) {}
  Vector(Vector&&) = default;
  Vector& operator=(Vector other) {
    std::swap(data_, other.data_);
    return *this;
  }

  double& operator[](int i) { return data_[i]; }
  double operator[](int i) const { return data_[i]; }
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  int size() const { return size_; }

 private:
  int size_;
  std::unique_ptr<double[]> data_;
};

Vector operator+(Vector a, const Vector& b) {
  for (int i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

Vector operator-(Vector a, const Vector& b) {
  for (int i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

Vector operator*(double factor, Vector a) {
  for (int i = 0; i < a.size(); ++i) a[i] *= factor;
  return a;
}

Vector operator*(implicitMatrix& A, Vector x) {
  Vector b(x.size());
  A.matVecMult(x.data(), b.data());
  return b;
}

double pairwise(const double* a, const double* b, int n) {
  if (n <= 16) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
  }
  const int half = n / 2;
  return pairwise(a, b, half) + pairwise(a + half, b + half, n - half);
}

double operator*(const Vector& a, const Vector& b) {
  return pairwise(a.data(), b.data(), a.size());
}

bool is_finite(const Vector& a) {
  for (int i = 0; i < a.size(); ++i)
    if (!std::isfinite(a[i])) return false;
  return true;
}

struct Solution {
  Vector x;
  double error;
  int steps;
};

Solution solve(implicitMatrix& A, const Vector& b, double epsilon, int most) {
  Vector x = b;
  Vector r = b - A * x;
  Vector d = r;
  double error = r * r;
  int steps = 0;
  while (std::isfinite(error) && error > epsilon && steps < most) {
    ++steps;
    const Vector Ad = A * d;
    const double dAd = d * Ad;
    if (!(dAd > 0 && dAd < HUGE_VAL)) break;
    const double alpha = error / dAd;
    Vector next = x + alpha * d;
    if (!is_finite(next)) break;
    x = std::move(next);
    r = steps % 64 == 0 ? b - A * x : r - alpha * Ad;
    const double previous = std::exchange(error, r * r);
    d = r + (error / previous) * d;
  }
  return {std::move(x), error, steps};
}

}  // namespace

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  if (n == 0) {
    *steps = 0;
    return 0;
  }
  const int most = *steps != 0 ? *steps : 2 * n > 100 ? 2 * n : 100;
  const Solution solution = solve(*A, Vector(n, b), epsilon, most);
  for (int i = 0; i < n; ++i) x[i] = solution.x[i];
  *steps = solution.steps;
  return solution.error;
}
