// STAFF ONLY. S1: the method of conjugate gradients.

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/linearSolver.h"

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  const int most = *steps == 0 ? std::max(100, 2 * n) : *steps;
  *steps = 0;
  if (n == 0) return 0;
  std::vector<double> r(n), d(n), q(n);

  auto true_residual = [&] {
    A->matVecMult(x, q.data());
    double rr = 0;
    for (int i = 0; i < n; ++i) {
      r[i] = b[i] - q[i];
      rr += r[i] * r[i];
    }
    return rr;
  };

  std::copy(b, b + n, x);
  double rr = true_residual();
  d = r;
  while (rr > epsilon && *steps < most && std::isfinite(rr)) {
    ++*steps;
    A->matVecMult(d.data(), q.data());
    double dq = 0;
    for (int i = 0; i < n; ++i) dq += d[i] * q[i];
    const double alpha = rr / dq;
    if (!(dq > 0) || !std::isfinite(alpha)) break;
    for (int i = 0; i < n; ++i) x[i] += alpha * d[i];
    double rr_new = 0;
    if (*steps % 64 == 0) {
      rr_new = true_residual();
    } else {
      for (int i = 0; i < n; ++i) {
        r[i] -= alpha * q[i];
        rr_new += r[i] * r[i];
      }
    }
    const double beta = rr_new / rr;
    rr = rr_new;
    for (int i = 0; i < n; ++i) d[i] = r[i] + beta * d[i];
  }
  return rr;
}
