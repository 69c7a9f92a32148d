// STAFF ONLY. S1: the method of conjugate gradients.

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/linearSolver.h"

namespace {

// term(0) + ... + term(n - 1), in eight sums side by side: no addition waits for the one before it, and two
// of them go in one instruction. A term may also update its place in a vector: one sweep through memory then
// does all there is to do.
template <class Term>
double sum(int n, Term term) {
  double s0 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0, s5 = 0, s6 = 0, s7 = 0;
  int i = 0;
  for (; i < n - 7; i += 8) {
    s0 += term(i);
    s1 += term(i + 1);
    s2 += term(i + 2);
    s3 += term(i + 3);
    s4 += term(i + 4);
    s5 += term(i + 5);
    s6 += term(i + 6);
    s7 += term(i + 7);
  }
  for (; i < n; ++i) s0 += term(i);
  return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7));
}

}  // namespace

// __restrict tells the compiler what the contract says, that vectors don't overlap; without it sweeps go
// value by value.
double ConjGrad(int n, implicitMatrix* A, double* __restrict x, double* __restrict b, double epsilon,
                int* steps) {
  const long long most = *steps == 0 ? std::max(100LL, 2LL * n) : *steps;
  *steps = 0;
  if (n == 0) return 0;

  std::vector<double> residual(n), direction(n), product(n);
  double* __restrict r = residual.data();
  double* __restrict d = direction.data();
  double* __restrict q = product.data();

  std::copy(b, b + n, x);
  A->matVecMult(x, q);
  double rr = sum(n, [=](int i) {
    d[i] = r[i] = b[i] - q[i];
    return r[i] * r[i];
  });
  double dd = rr;
  double reach = std::sqrt(sum(n, [=](int i) { return b[i] * b[i]; }));  // no |x_i| is larger

  while (rr > epsilon && std::isfinite(rr) && *steps < most) {
    ++*steps;
    A->matVecMult(d, q);
    const double dAd = sum(n, [=](int i) { return d[i] * q[i]; });
    const double alpha = rr / dAd;  // how far along d the error is smallest
    if (!(dAd > 0) || !std::isfinite(dAd) || !std::isfinite(alpha)) break;

    // x is looked at before it changes, but only when it may be about to overflow.
    reach += alpha * std::sqrt(dd);
    if (!(reach < 1e300) && !std::isfinite(sum(n, [=](int i) { return 0 * (x[i] + alpha * d[i]); }))) break;

    double rr_new, ahead = alpha;  // how far x still has to go
    if (*steps % 64 == 0) {
      for (int i = 0; i < n; ++i) x[i] += alpha * d[i];
      ahead = 0;
      A->matVecMult(x, q);
      rr_new = sum(n, [=](int i) {
        r[i] = b[i] - q[i];
        return r[i] * r[i];
      });
    } else {
      rr_new = sum(n, [=](int i) {
        r[i] -= alpha * q[i];
        return r[i] * r[i];
      });
    }
    const double beta = rr_new / rr;  // makes the next d conjugate to all before: d'A d_old = 0
    dd = sum(n, [=](int i) {
      x[i] += ahead * d[i];
      d[i] = r[i] + beta * d[i];
      return d[i] * d[i];
    });
    rr = rr_new;
  }
  return rr;
}
