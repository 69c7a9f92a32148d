// STAFF ONLY. Angular springs against the continuum that they stand for: energies and shapes do not depend on
// how finely a strand is divided, to second order.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hair/make_strand.h"
#include "hair/stretch_springs.h"
#include "reference/tests/bend.h"

namespace reference_tests {
namespace {

using std::numbers::pi;

// A helix of curvature kappa: E = EI/2 kappa^2 L, whatever its torsion.
TEST(AngularSprings, ApproachTheContinuumsEnergyToSecondOrder) {
  const double EI = 4, radius = 0.3, pitch = 0.2, L = 2;
  const double a = std::sqrt(radius * radius + pitch * pitch), kappa = radius / (a * a);
  const double exact = EI / 2 * kappa * kappa * L;
  std::vector<double> errors;
  for (int n : {16, 32, 64, 128}) {
    Strand strand = test_strand(n + 1);
    strand.bend_rigidity = EI;
    strand.rest_length.setConstant(L / n);
    VectorXd x(3 * n + 3);
    for (int i = 0; i <= n; ++i) {
      const double t = L * i / n / a;
      x.segment<3>(3 * i) = Vector3d(radius * std::cos(t), radius * std::sin(t), pitch * t);
    }
    strand.clamped = true;
    // Where the curve begins, so that the root's joint bends like half of another one.
    strand.root_tangent = Vector3d(0, radius, pitch) / a;
    // The last half segment's bend is nobody's.
    errors.push_back(std::abs(bend_energy(strand, x) + EI / 2 * kappa * kappa * L / n / 2 - exact));
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(errors[i - 1] / errors[i], 4, 0.4)
        << "halving the segments, the " << i << "th time: second order";
}

// A clamped strand along x in gravity, at rest: Newton's method on the energy, loads in steps, root fixed.
VectorXd static_shape(const Strand& strand, double weight) {
  const int n = strand.segments(), free = 3 * n;
  VectorXd x = VectorXd::Zero(3 * n + 3);
  for (int i = 0; i < n; ++i) x[3 * i + 3] = x[3 * i] + strand.rest_length[i];
  // A coordinate is known to u, and so a segment's force to EA / l0 of that.
  const double rounding = 8 * kUnit * strand.stretch_rigidity * n;
  for (int load = 1; load <= 8; ++load) {
    double residual = 1;
    for (int iteration = 0; iteration < 60 && residual > rounding; ++iteration) {
      VectorXd f = bend_force(strand, x);
      add_stretch_force(strand, x, f);
      for (int i = 1; i <= n; ++i) f[3 * i + 2] -= weight * load / 8 * strand.mass[i] / strand.mass.sum();
      MatrixXd K = -bend_matrix(strand, x);
      K -= matrix_of(
          [&](const VectorXd& dx) {
            VectorXd df = VectorXd::Zero(x.size());
            add_stretch_product(strand, x, hair::GeometricTerm::full, dx, df);
            return df;
          },
          x.size());
      VectorXd step = K.bottomRightCorner(free, free).ldlt().solve(f.tail(free));
      step *= std::min(1.0, 0.2 / step.lpNorm<Eigen::Infinity>());
      x.tail(free) += step;
      residual = f.tail(free).norm();
    }
    EXPECT_LE(residual, 8 * rounding) << "Newton's method has not converged";
  }
  return x;
}

Strand cantilever(int n) {
  Strand strand = test_strand(n + 1);
  strand.rest_length.setConstant(1.0 / n);
  strand.mass.setConstant(1.0 / n);
  strand.mass[0] /= 2;
  strand.mass[n] /= 2;
  strand.bend_rigidity = 1;
  strand.stretch_rigidity = 1e4;
  strand.clamped = true;
  strand.root_tangent = Vector3d::UnitX();
  return strand;
}

TEST(AngularSprings, GiveAClampedBeamItsSmallDeflection) {
  // A weight w spread along the beam: w L^3 / 8 EI at the tip (Euler, Bernoulli).
  std::vector<double> errors;
  for (int n : {4, 8, 16, 32})
    errors.push_back(std::abs(-static_shape(cantilever(n), 1e-3)[3 * n + 2] - 1e-3 / 8));
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(errors[i - 1] / errors[i], 4, 0.4)
        << "halving the segments, the " << i << "th time: second order";
  EXPECT_LE(errors.back(), 1e-3 / 8 * 2 / (32 * 32));
}

TEST(AngularSprings, GiveTheSameStaticShapeHoweverTheStrandIsDivided) {
  // w L^2 / EI = 5: the tip hangs half of the length down.
  std::vector<Vector3d> tips;
  for (int n : {4, 8, 16, 32}) tips.push_back(static_shape(cantilever(n), 5).tail<3>());
  EXPECT_LT(tips.back().z(), -0.4);
  for (std::size_t i = 2; i < tips.size(); ++i)
    EXPECT_NEAR((tips[i - 1] - tips[i - 2]).norm() / (tips[i] - tips[i - 1]).norm(), 4, 0.6)
        << "how far the tip moves when the segments are halved, the " << i << "th time: second order";
}

// Degrees that each joint of human hair, on a hinge and in segments of 1 cm, may be bent by until M + h^2 K
// is no longer positive definite, to a quarter; h = 1/60 s.
double bend_that_is_too_much(int n, bool spd) {
  const double l = 0.01, h = 1.0 / 60;
  const Strand strand = hair::uniform_strand({}, n, n * l);
  for (double degrees = 1; degrees < 90; degrees += 0.25) {
    const double phi = degrees * pi / 180;
    VectorXd x = VectorXd::Zero(3 * n + 3);
    for (int i = 0; i < n; ++i)
      x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + l * Vector3d(std::sin(phi * i), 0, -std::cos(phi * i));
    MatrixXd A = -h * h * (spd ? bend_matrix_spd(strand, x) : bend_matrix(strand, x));
    A -= h * h *
         matrix_of(
             [&](const VectorXd& dx) {
               VectorXd df = VectorXd::Zero(x.size());
               add_stretch_product(strand, x, hair::GeometricTerm::filtered, dx, df);
               return df;
             },
             x.size());
    for (int i = 0; i <= n; ++i) A.diagonal().segment<3>(3 * i).array() += strand.mass[i];
    const MatrixXd free = A.bottomRightCorner(3 * n, 3 * n);
    if (Eigen::SelfAdjointEigenSolver<MatrixXd>(free).eigenvalues()[0] <= 0) return degrees;
  }
  return 90;
}

TEST(AngularSprings, MakeAnImplicitStepOfHairIndefiniteFromTwentyToTwentySixDegrees) {
  EXPECT_NEAR(bend_that_is_too_much(3, false), 19.5, 0.5);
  EXPECT_NEAR(bend_that_is_too_much(12, false), 25.25, 0.5);
  for (int n : {3, 12})
    EXPECT_EQ(bend_that_is_too_much(n, true), 90) << "never, with the semi-definite product";
}

}  // namespace
}  // namespace reference_tests
