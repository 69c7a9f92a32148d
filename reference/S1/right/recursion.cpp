// STAFF ONLY. A right S1 by recursion: sums are sums of two halves, and 2m steps are m steps, and m more if
// those did not end it. It uses alpha = d'r / d'Ad and beta = -r'Ad / d'Ad, which hold for every d.
#include <cmath>
#include <cstring>
#include <vector>

#include "solver/linearSolver.h"

namespace {

double dot(const double* a, const double* b, int n) {
  if (n <= 3) {
    double sum = 0;
    while (n-- > 0) sum += *a++ * *b++;
    return sum;
  }
  const int half = n / 2;
  return dot(a, b, half) + dot(a + half, b + half, n - half);
}

bool finite(const double* a, int n) {
  return n == 0 || (std::isfinite(*a) && (n == 1 || (finite(a, n / 2) && finite(a + n / 2, n - n / 2))));
}

struct Solve {
  int n;
  implicitMatrix* A;
  double *x, *b;
  double epsilon;
  int steps;
  std::vector<double> r, d, Ad, next, Ax;
  double rr;

  void take_residual(double at[]) {
    A->matVecMult(at, Ax.data());
    for (int i = 0; i < n; ++i) r[i] = b[i] - Ax[i];
  }

  // True if there is more to do.
  bool step() {
    ++steps;
    A->matVecMult(d.data(), Ad.data());
    const double dAd = dot(d.data(), Ad.data(), n), alpha = dot(d.data(), r.data(), n) / dAd;
    if (!(dAd > 0 && std::isfinite(dAd) && std::isfinite(alpha))) return false;
    for (int i = 0; i < n; ++i) next[i] = x[i] + alpha * d[i];
    if (!finite(next.data(), n)) return false;
    std::memcpy(x, next.data(), n * sizeof(double));
    if (steps % 64 == 0)
      take_residual(x);
    else
      for (int i = 0; i < n; ++i) r[i] -= alpha * Ad[i];
    const double beta = -dot(r.data(), Ad.data(), n) / dAd;
    for (int i = 0; i < n; ++i) d[i] = r[i] + beta * d[i];
    rr = dot(r.data(), r.data(), n);
    return goes_on();
  }

  bool goes_on() const { return rr > epsilon && std::isfinite(rr); }

  bool take(int count) {
    if (count <= 0) return true;
    if (count == 1) return step();
    return take(count / 2) && take(count - count / 2);
  }
};

}  // namespace

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  int most = *steps;
  if (most == 0) most = n < 50 ? 100 : 2 * n;
  *steps = 0;
  if (n == 0) return 0;
  const std::vector<double> none(n);
  Solve solve{n, A, x, b, epsilon, 0, none, none, none, none, none, 0};
  std::memcpy(x, b, n * sizeof(double));
  solve.take_residual(x);
  solve.d = solve.r;
  solve.rr = dot(solve.r.data(), solve.r.data(), n);
  if (solve.goes_on()) solve.take(most);
  *steps = solve.steps;
  return solve.rr;
}
