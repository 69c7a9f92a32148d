// STAFF ONLY. A right S1 whose helpers have external linkage and take names that other files of the class
// use, too: the other exercise's file and the reference's. Whoever links these together without care gets one
// of them for all.
#include <cmath>
#include <cstdlib>

#include "solver/linearSolver.h"

// term(0) + ... + term(n - 1)
template <class Term>
double sum(int n, Term term) {
  double all = 0;
  for (int i = 0; i < n; ++i) all += term(i);
  return all;
}

double dot(int n, const double* a, const double* b) {
  return sum(n, [=](int i) { return a[i] * b[i]; });
}

void true_residual(int n, implicitMatrix* A, double* x, const double* b, double* r) {
  A->matVecMult(x, r);
  for (int i = 0; i < n; ++i) r[i] = b[i] - r[i];
}

// y = a + factor * b
void axpy(int n, double factor, const double* a, const double* b, double* y) {
  for (int i = 0; i < n; ++i) y[i] = a[i] + factor * b[i];
}

struct Workspace {
  explicit Workspace(int n)
      : memory(static_cast<double*>(std::calloc(n, 4 * sizeof(double)))),
        r(memory),
        d(r + n),
        q(d + n),
        next(q + n) {}
  ~Workspace() { std::free(memory); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  double *memory, *r, *d, *q, *next;
};

int max_steps(int n, int wanted) {
  if (wanted != 0) return wanted;
  return n > 50 ? 2 * n : 100;
}

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  const int most = max_steps(n, *steps);
  *steps = 0;
  if (n == 0) return 0;

  Workspace work(n);
  axpy(n, 0, b, work.d, x);
  true_residual(n, A, x, b, work.r);
  axpy(n, 0, work.r, work.d, work.d);
  double rr = dot(n, work.r, work.r);

  for (;;) {
    if (!std::isfinite(rr) || rr <= epsilon || *steps >= most) return rr;
    ++*steps;
    A->matVecMult(work.d, work.q);
    const double dq = dot(n, work.d, work.q);
    if (!std::isfinite(dq) || dq <= 0) return rr;
    const double alpha = rr / dq;
    if (!std::isfinite(alpha)) return rr;
    axpy(n, alpha, x, work.d, work.next);
    for (int i = 0; i < n; ++i) {
      if (!std::isfinite(work.next[i])) return rr;
    }
    axpy(n, 0, work.next, work.d, x);
    if (*steps % 64 == 0) {
      true_residual(n, A, x, b, work.r);
    } else {
      axpy(n, -alpha, work.r, work.q, work.r);
    }
    const double before = rr;
    rr = dot(n, work.r, work.r);
    axpy(n, rr / before, work.r, work.d, work.d);
  }
}
