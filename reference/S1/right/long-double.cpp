// STAFF ONLY. A right S1 in long double: vectors and sums, all but what matrices take and give.
#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/linearSolver.h"

namespace {

using Real = long double;

class Product {
 public:
  Product(int n, implicitMatrix* A) : A_(A), in_(n), out_(n) {}

  const std::vector<double>& of(const std::vector<Real>& x) {
    for (std::size_t i = 0; i < x.size(); ++i) in_[i] = static_cast<double>(x[i]);
    A_->matVecMult(in_.data(), out_.data());
    return out_;
  }

 private:
  implicitMatrix* A_;
  std::vector<double> in_, out_;
};

template <typename Vector>
Real dot(const std::vector<Real>& a, const Vector& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * static_cast<Real>(b[i]);
  return sum;
}

}  // namespace

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  const long most = *steps != 0 ? *steps : std::max(100L, 2L * n);
  *steps = 0;
  std::vector<Real> solution(b, b + n), r(b, b + n);
  std::copy(b, b + n, x);
  if (n == 0) return 0;
  Product A_times(n, A);
  const auto subtract = [&](Real factor, const std::vector<double>& change) {
    for (int i = 0; i < n; ++i) r[i] -= factor * change[i];
  };
  subtract(1, A_times.of(solution));
  std::vector<Real> d = r;
  Real rr = dot(r, r);
  while (std::isfinite(rr) && rr > epsilon && *steps < most) {
    ++*steps;
    const std::vector<double>& Ad = A_times.of(d);
    const Real dAd = dot(d, Ad);
    if (!std::isfinite(dAd) || dAd <= 0) break;
    const Real alpha = rr / dAd;
    // What the caller gets is a double, and must be finite as one.
    bool finite = true;
    for (int i = 0; i < n; ++i) finite &= std::isfinite(static_cast<double>(solution[i] + alpha * d[i]));
    if (!finite) break;
    for (int i = 0; i < n; ++i) x[i] = static_cast<double>(solution[i] += alpha * d[i]);
    if (*steps % 64 == 0) {
      r.assign(b, b + n);
      subtract(1, A_times.of(solution));
    } else {
      subtract(alpha, Ad);
    }
    const Real rr_before = rr;
    rr = dot(r, r);
    for (int i = 0; i < n; ++i) d[i] = r[i] + rr / rr_before * d[i];
  }
  return static_cast<double>(rr);
}
