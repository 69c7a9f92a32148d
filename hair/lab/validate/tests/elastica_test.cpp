// The elastica by another method than shooting.
#include "hair/lab/validate/elastica.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/dense_solve.h"

namespace hair {
namespace {

constexpr double kPi = std::numbers::pi;

// Collocation at Chebyshev's points t_i = (1 - cos(pi i / n)) / 2, with the matrix of derivatives there (L.
// N. Trefethen, "Spectral Methods in MATLAB", 2000, chapter 6): psi'' = Gamma t sin(psi), psi'(0) = 0, psi(1)
// = pi/2, by Newton's method. Positions are integrals, so they use the inverse of the same matrix.
Eigen::Vector2d collocated_tip(double gamma, int n) {
  const auto point = [n](int i) { return (1 - std::cos(kPi * i / n)) / 2; };
  const auto weight = [n](int i) { return (i == 0 || i == n ? 2.0 : 1.0) * (i % 2 == 0 ? 1 : -1); };
  Eigen::VectorXd t(n + 1);
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n + 1, n + 1);
  for (int i = 0; i <= n; ++i) {
    t[i] = point(i);
    for (int j = 0; j <= n; ++j)
      if (i != j) D(i, j) = weight(i) / weight(j) / (point(i) - point(j));
    D(i, i) = -D.row(i).sum();
  }
  const Eigen::MatrixXd D2 = D * D;
  Eigen::VectorXd psi = kPi / 2 * t;
  for (int iteration = 0; iteration < 60; ++iteration) {
    Eigen::VectorXd left = D2 * psi - gamma * (t.array() * psi.array().sin()).matrix();
    Eigen::MatrixXd J = D2;
    J.diagonal() -= gamma * (t.array() * psi.array().cos()).matrix();
    left[0] = D.row(0).dot(psi);
    J.row(0) = D.row(0);
    left[n] = psi[n] - kPi / 2;
    J.row(n).setZero();
    J(n, n) = 1;
    const Eigen::VectorXd step = solver::dense_solve(J, left);
    psi -= std::min(1.0, 0.5 / step.cwiseAbs().maxCoeff()) * step;
  }
  // Integrates the slopes sin(psi) and cos(psi) from the tip, where the integral is 0, up to the clamp.
  const auto integral = [&](const Eigen::VectorXd& slope) {
    return solver::dense_solve(D.bottomRightCorner(n, n), slope.tail(n))(n - 1, 0);
  };
  return {integral(psi.array().sin()), integral(psi.array().cos())};
}

// Rounding of D^2, whose entries reach n^4: 2^-53 of it. The truncation error of n points falls like exp(-n).
TEST(Elastica, CollocationFindsTheSameTip) {
  constexpr int kPoints = 48;
  const double rounding = 0x1p-53 * std::pow(kPoints, 4);
  for (const double gamma : {0.1, 1.0, 10.0, 100.0}) {
    const Elastica curve = elastica(gamma);
    const Eigen::Vector2d tip = collocated_tip(gamma, kPoints);
    EXPECT_LE((curve.tip() - tip).norm(), curve.error + rounding)
        << "Gamma = " << gamma << ": " << curve.tip().transpose() << " by shooting, " << tip.transpose()
        << " by collocation";
  }
}

}  // namespace
}  // namespace hair
