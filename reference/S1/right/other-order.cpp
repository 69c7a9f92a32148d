// STAFF ONLY. A right S1 in another order: sums run from the last entry to the first, the top of the loop
// makes the direction (Hestenes and Stiefel's d_k = r_k + beta_k d_(k-1)), and x and r share one loop.
#include <cfloat>
#include <vector>

#include "solver/linearSolver.h"

namespace {

// False for NaN, too.
bool finite(double value) {
  return value >= -DBL_MAX && value <= DBL_MAX;
}

// r = b - Ax, and its squared norm.
double residual(int n, implicitMatrix* A, double* x, const double* b, double* r) {
  A->matVecMult(x, r);
  double sum = 0;
  for (int i = n; i-- > 0;) {
    r[i] = b[i] - r[i];
    sum += r[i] * r[i];
  }
  return sum;
}

}  // namespace

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  int left = *steps;
  if (left == 0) left = 2 * n > 100 ? 2 * n : 100;
  *steps = 0;
  if (n <= 0) return 0;

  // Four vectors in one block: residual, direction, product, and the x to go back to.
  std::vector<double> memory(4 * static_cast<std::size_t>(n), 0.0);
  double* r = memory.data();
  double* d = r + n;
  double* Ad = d + n;
  double* x_before = Ad + n;

  for (int i = n; i-- > 0;) x[i] = b[i];
  double now = residual(n, A, x, b, r);
  double before = 0;

  for (; left > 0 && finite(now) && !(now <= epsilon); --left) {
    const double beta = before > 0 ? now / before : 0;
    for (int i = n; i-- > 0;) d[i] = *steps == 0 ? r[i] : r[i] + beta * d[i];
    ++*steps;

    A->matVecMult(d, Ad);
    double curvature = 0;
    for (int i = n; i-- > 0;) curvature += Ad[i] * d[i];
    if (!finite(curvature) || curvature <= 0) return now;
    const double alpha = now / curvature;
    if (!finite(alpha)) return now;

    bool good = true;
    for (int i = n; i-- > 0;) {
      x_before[i] = x[i];
      x[i] += alpha * d[i];
      good = good && finite(x[i]);
      r[i] -= alpha * Ad[i];
    }
    if (!good) {
      for (int i = n; i-- > 0;) x[i] = x_before[i];
      return now;
    }

    before = now;
    if (*steps % 64 == 0) {
      now = residual(n, A, x, b, r);
    } else {
      now = 0;
      for (int i = n; i-- > 0;) now += r[i] * r[i];
    }
  }
  return now;
}
