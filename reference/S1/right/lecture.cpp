// STAFF ONLY. A right S1 as the lecture writes C++: its header without a folder, arrays with new and delete, and no library
// but C's.
#include <math.h>

#include "linearSolver.h"

static double sqrLength(int n, double v[]) {
  double sum = 0.0;
  for (int i = 0; i < n; i++) sum += v[i] * v[i];
  return sum;
}

static int isNumber(double value) {
  return value - value == 0.0;
}

// Solve Ax = b for a symmetric, positive definite matrix A
double ConjGrad(int n, implicitMatrix* A, double x[], double b[],
                double epsilon,  // how low should we go?
                int* steps) {
  int i, iMax = *steps;
  double *r, *d, *t, rSqrLen, rSqrLenOld, alpha, beta, u;

  if (iMax == 0) iMax = n > 50 ? 2 * n : 100;
  *steps = 0;
  if (n == 0) return 0.0;

  r = new double[n];
  d = new double[n];
  t = new double[n];

  for (i = 0; i < n; i++) x[i] = b[i];
  A->matVecMult(x, t);
  for (i = 0; i < n; i++) d[i] = r[i] = b[i] - t[i];
  rSqrLen = sqrLength(n, r);

  while (rSqrLen > epsilon && isNumber(rSqrLen) && *steps < iMax) {
    int bad = 0;
    *steps = *steps + 1;
    A->matVecMult(d, t);
    u = 0.0;
    for (i = 0; i < n; i++) u += d[i] * t[i];
    if (u <= 0.0 || !isNumber(u)) break;
    alpha = rSqrLen / u;
    for (i = 0; i < n; i++) bad += !isNumber(x[i] + alpha * d[i]);
    if (bad) break;
    for (i = 0; i < n; i++) x[i] += alpha * d[i];

    if (*steps & 0x3F) {
      for (i = 0; i < n; i++) r[i] -= alpha * t[i];
    } else {  // every 64th iteration starts from x again
      A->matVecMult(x, t);
      for (i = 0; i < n; i++) r[i] = b[i] - t[i];
    }
    rSqrLenOld = rSqrLen;
    rSqrLen = sqrLength(n, r);
    beta = rSqrLen / rSqrLenOld;
    for (i = 0; i < n; i++) d[i] = r[i] + beta * d[i];
  }

  delete[] r;
  delete[] d;
  delete[] t;
  return rSqrLen;
}
