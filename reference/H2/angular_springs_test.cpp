// STAFF ONLY. The second products of angular springs, and the bends at which implicit steps are indefinite.
// Shapes, frequencies and energies are in validate/. The public checks test the promises of
// hair/angular_springs.h.

#include "hair/angular_springs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hair/strand/make_strand.h"
#include "hair/strand/test_strand_states.h"
#include "hair/stretch_springs.h"
#include "solver/dense_algebra.h"

namespace reference_tests {
namespace {

using std::numbers::pi;

VectorXd bend_product(const Strand& strand, const VectorXd& x, const VectorXd& dx) {
  VectorXd sum = VectorXd::Zero(x.size());
  add_bend_product(strand, x, dx, sum);
  return sum;
}

MatrixXd bend_matrix(const Strand& strand, const VectorXd& x) {
  return matrix_of([&](const VectorXd& dx) { return bend_product(strand, x, dx); }, x.size());
}

MatrixXd bend_matrix_spd(const Strand& strand, const VectorXd& x) {
  return matrix_of(
      [&](const VectorXd& dx) {
        VectorXd sum = VectorXd::Zero(x.size());
        add_bend_product_spd(strand, x, dx, sum);
        return sum;
      },
      x.size());
}

// Three particles, segments of length l, bent by phi in the plane of x and z.
StrandState one_joint(double l, double phi, double EI) {
  StrandState s{"one joint", test_strand(3), VectorXd::Zero(9), l, pi - phi};
  s.strand.rest_length.setConstant(l);
  s.strand.bend_rigidity = EI;
  s.x.segment<3>(3) = Vector3d(0, 0, -l);
  s.x.segment<3>(6) = s.x.segment<3>(3) + l * Vector3d(std::sin(phi), 0, -std::cos(phi));
  return s;
}

TEST(AngularSprings, HaveASecondProductThatApproachesTheExactOneWithTheBend) {
  // The product leaves out terms of first order in phi: phi tan(phi/2), and the turning of forces, k phi.
  for (double phi : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-14}) {
    const StrandState s = one_joint(0.7, phi, 4);
    const MatrixXd difference = bend_matrix_spd(s.strand, s.x) - bend_matrix(s.strand, s.x);
    const double k = 4 / 0.7 / (0.7 * 0.7);
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), k * (8 * phi + 256 * kUnit)) << "phi = " << phi;
  }
}

// The bend of each joint, in degrees to a quarter, at which M + h^2 K stops being positive definite, for
// human hair on a hinge, in segments of 1 cm; h = 1/60 s.
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
    if (solver::symmetric_eigenvalues(free)[0] <= 0) return degrees;
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
