#include "hair/lab/stability/theory.h"

#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

#include "particles/require.h"
#include "solver/dense_algebra.h"

namespace hair {

namespace {

using Complex = std::complex<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// 1 + z + z^2/2 + ... up to so many powers.
double amplification(int powers, Complex z) {
  Complex sum = 1, term = 1;
  for (int k = 1; k <= powers; ++k) sum += term *= z / static_cast<double>(k);
  return std::abs(sum);
}

// The first h > 0 beyond which |R(h lambda)| > growth. |h lambda| = 4 is outside of all three regions, and
// each region is star-shaped from 0: a ray from 0 leaves it once.
double polynomial_limit(int powers, Complex lambda, double growth) {
  const double size = std::abs(lambda);
  if (size == 0) return kInfinity;
  // Rounding of a sum of numbers up to 1; RK4 is within 1e-15 of 1 for |z| < 0.02.
  const double bound = growth + 1e-15;
  constexpr double kStride = 1.0 / 64;
  double low = 0, high = 0;
  do {
    low = high;
    high += kStride;
  } while (amplification(powers, high / size * lambda) <= bound);
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (amplification(powers, middle / size * lambda) <= bound ? low : high) = middle;
  }
  // Midpoint without drag: 1 + z^4/8 rounds to 1 for |z| up to 3e-4.
  return low < 1e-3 && lambda.real() == 0 && growth == 1 ? 0 : low / size;
}

}  // namespace

double explicit_limit(Method method, const Oscillator& oscillator, double growth) {
  const auto [omega, gamma] = oscillator;
  particles::require_at_least("a frequency", omega, 0);
  particles::require_at_least("drag", gamma, 0);
  particles::require_at_least("the growth in a step", growth, 1);
  if (method == Method::symplectic_euler) {
    // z^2 - (2 - h gamma - h^2 omega^2) z + (1 - h gamma) = 0 at z = -growth.
    const double both = (growth + 1) * gamma,
                 root = std::hypot(both, 2 * omega * std::sqrt(growth) * (growth + 1));
    return both + root == 0 ? kInfinity : 2 * (growth + 1) * (growth + 1) / (both + root);
  }
  const int powers = row_of(method).polynomial;
  if (powers == 0) throw std::invalid_argument("this method's stability function is no part of exp's series");
  const double discriminant = gamma * gamma / 4 - omega * omega;
  if (discriminant < 0) return polynomial_limit(powers, {-gamma / 2, std::sqrt(-discriminant)}, growth);
  return polynomial_limit(powers, {-gamma / 2 - std::sqrt(discriminant), 0},
                          growth);  // the faster of the two
}

double implicit_limit(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                      const Eigen::MatrixXd& in_matrix, double gamma, double growth) {
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd matrix =
      scale.asDiagonal() * (growth * stiffness - growth * (growth + 1) * in_matrix) * scale.asDiagonal();
  const Eigen::VectorXd values = solver::symmetric_eigenvalues(matrix);
  const double mu = values.maxCoeff();
  // A value below the rounding of the largest is 0.
  if (mu <= 1e-12 * values.cwiseAbs().maxCoeff()) return kInfinity;
  const double drag = growth * (growth + 1) * gamma, least = 2 * (growth + 1) * std::sqrt(mu);
  return (drag + std::hypot(drag, least)) / (2 * mu);
}

double predictor_corrector_limit(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                                 const Eigen::MatrixXd& in_matrix, double gamma, double most, double growth) {
  // With T = S^-1 M a step from w to w is x' = x + h w, w' = T^2 w - (T + 1) S^-1 (h/2 K) x'. An error z = -g
  // has x' = -g x, so that w = -(1 + g) x / h, and ((1 + g) (g + T^2) - g (T + 1) S^-1 (h^2/2 K)) x = 0. For
  // small steps T is near 1, and the determinant positive.
  const Eigen::MatrixXd masses = mass.asDiagonal(), one = Eigen::MatrixXd::Identity(mass.size(), mass.size());
  const auto positive = [&](double h) {
    const Eigen::MatrixXd s = (1 + h * gamma / 2) * masses + h * h / 2 * in_matrix;
    const Eigen::MatrixXd t = solver::dense_solve(s, masses);
    return solver::determinant_sign((1 + growth) * (growth * one + t * t) -
                                    growth * (t + one) * solver::dense_solve(s, h * h / 2 * stiffness)) >= 0;
  };
  constexpr double kStride = 1.05;  // two modes whose limits are nearer than this could hide each other
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const double square =
      solver::symmetric_eigenvalues(scale.asDiagonal() * stiffness * scale.asDiagonal()).maxCoeff();
  if (square <= 0) return kInfinity;
  double low = 1 / std::sqrt(square), high = low;
  while (positive(high)) {
    if (high >= most) return kInfinity;
    low = high;
    high *= kStride;
  }
  for (int k = 0; k < 40; ++k) {
    const double middle = std::sqrt(low * high);
    (positive(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace hair
