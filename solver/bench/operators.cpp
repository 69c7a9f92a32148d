#include "solver/bench/operators.h"

// The loops use the machine's widest registers, unlike the solvers, because the solvers are measured.
#if defined(__x86_64__) && defined(__linux__)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

namespace solver_bench {

namespace {

// out_i = centre x_i - neighbour (x_{i-stride} + x_{i+stride}) for i = 0 .. n - 1.
WIDE void chain(int n, int stride, double centre, double neighbour, const double* __restrict x,
                double* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = centre * x[i] - neighbour * (x[i - stride] + x[i + stride]);
}

// out_i = 4 x_i - the values on its left and right, above and below, for i = 0 .. n - 1.
WIDE void five_points(int n, const double* __restrict x, const double* __restrict above,
                      const double* __restrict below, double* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = 4 * x[i] - (x[i - 1] + x[i + 1]) - (above[i] + below[i]);
}

}  // namespace

void StrandOperator::matVecMult(double x[], double b[]) {
  const double s = spring_;
  for (int i = 0; i < 3; ++i) b[i] = (1 + 2 * s) * x[i] - s * x[i + 3];
  chain(n_ - 6, 3, 1 + 2 * s, s, x + 3, b + 3);
  for (int i = n_ - 3; i < n_; ++i) b[i] = (1 + s) * x[i] - s * x[i - 3];
}

void PoissonOperator::matVecMult(double x[], double b[]) {
  const int m = side_, last = m - 1;
  for (int j = 0; j < m; ++j) {
    const double* row = x + static_cast<long>(j) * m;
    const double* above = j > 0 ? row - m : boundary_.data();
    const double* below = j < last ? row + m : boundary_.data();
    double* out = b + static_cast<long>(j) * m;
    out[0] = 4 * row[0] - row[1] - (above[0] + below[0]);
    five_points(m - 2, row + 1, above + 1, below + 1, out + 1);
    out[last] = 4 * row[last] - row[last - 1] - (above[last] + below[last]);
  }
}

}  // namespace solver_bench
