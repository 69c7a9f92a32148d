// STAFF ONLY. A right S1, the textbook's algorithm line by line. The patches for S1 apply to it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/linearSolver.h"

using std::vector;

static double dot(const vector<double>& a, const vector<double>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

static bool all_finite(const vector<double>& a) {
  return std::all_of(a.begin(), a.end(), [](double value) { return std::isfinite(value); });
}

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  int max_steps = *steps;
  if (max_steps == 0) max_steps = std::max(100, 2 * n);
  *steps = 0;
  if (n == 0) return 0;

  vector<double> r(n), d(n), q(n), x_new(n);

  // The first guess is x = b.
  for (int i = 0; i < n; ++i) x[i] = b[i];

  // r = b - Ax
  A->matVecMult(x, q.data());
  for (int i = 0; i < n; ++i) r[i] = b[i] - q[i];
  d = r;
  double rr = dot(r, r);

  while (rr > epsilon && std::isfinite(rr) && *steps < max_steps) {
    *steps += 1;

    // alpha = r'r / d'Ad
    A->matVecMult(d.data(), q.data());
    double dq = dot(d, q);
    double alpha = rr / dq;
    if (!(dq > 0) || !std::isfinite(dq) || !std::isfinite(alpha)) break;

    // x = x + alpha d
    for (int i = 0; i < n; ++i) x_new[i] = x[i] + alpha * d[i];
    if (!all_finite(x_new)) break;
    for (int i = 0; i < n; ++i) x[i] = x_new[i];

    // r = b - Ax, most of the time by r = r - alpha Ad
    if (*steps % 64 == 0) {
      A->matVecMult(x, q.data());
      for (int i = 0; i < n; ++i) r[i] = b[i] - q[i];
    } else {
      for (int i = 0; i < n; ++i) r[i] -= alpha * q[i];
    }

    // d = r + beta d
    double rr_new = dot(r, r);
    double beta = rr_new / rr;
    for (int i = 0; i < n; ++i) d[i] = r[i] + beta * d[i];
    rr = rr_new;
  }
  return rr;
}
