#include "hair/lab/validate/hanging_chain.h"

#include <algorithm>
#include <cmath>

#include "solver/dense_algebra.h"

namespace hair {

namespace {

// x - L_n(x) / L_n'(x), where x L_n' = n (L_n - L_{n-1}).
double newton_step(int n, double x) {
  double before = 0, value = 1;
  for (int j = 0; j < n; ++j) {
    const double next = ((2 * j + 1 - x) * value - j * before) / (j + 1);
    before = value;
    value = next;
  }
  return x - x * value / (n * (value - before));
}

}  // namespace

Eigen::VectorXd laguerre_zeros(int n) {
  Eigen::VectorXd diagonal(n), beside(n - 1);
  for (int j = 0; j < n; ++j) diagonal[j] = 2 * j + 1;
  for (int j = 1; j < n; ++j) beside[j - 1] = j;
  Eigen::VectorXd zeros = solver::tridiagonal_eigenvalues(diagonal, beside);
  for (double& zero : zeros) zero = newton_step(n, zero);
  return zeros;
}

Eigen::VectorXd mode_angles(const HangingChain& chain, double x) {
  const int n = chain.count();
  Eigen::VectorXd angles(n);
  // From the tip up: the tension's sideways part in link i accelerates all masses below it.
  double sideways = 1, momentum = 0;
  for (int i = n - 1; i >= 0; --i) {
    momentum += chain.mass[i] * sideways;
    angles[i] = x * chain.gravity * momentum / chain.tension(i);
    sideways -= angles[i];
  }
  return angles / angles.cwiseAbs().maxCoeff();
}

double softening(const HangingChain& chain, double x, const Eigen::VectorXd& angles) {
  const int n = chain.count();
  const double l = chain.link;
  double tau = 0, nu = 0, inertia = 0;
  for (int i = 0; i < n; ++i) {
    nu += l * chain.tension(i) * std::pow(angles[i], 4) / 64;
    for (int j = 0; j < n; ++j) {
      const double pair = l * l * chain.tension(std::max(i, j)) / chain.gravity * angles[i] * angles[j];
      inertia += pair;
      tau -= pair * std::pow(angles[i] - angles[j], 2) / 32;
    }
  }
  return -4 * (tau + nu / (chain.square_unit() * x)) / inertia;
}

double period_ratio(double angle) {
  double a = 1, g = std::cos(angle / 2);
  while (std::abs(a - g) > 1e-15) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  return 1 / a;
}

}  // namespace hair
