// STAFF ONLY. The promises of hair/mass_spring/rest_curvature.h for joints near the fold, and for segments
// without a direction.
#include <gtest/gtest.h>

#include <cmath>

#include "hair/mass_spring/test_rest_curvature_cases.h"

namespace hair {
namespace {

TEST(RestCurvature, StaysFiniteWhereDirectionsAreLost) {
  Strand strand = reference_tests::test_strand(5);
  strand.clamped = true;
  const Vector3d normal(1, 0, 0);
  VectorXd fold(15), none = VectorXd::Ones(15), one(15);
  fold << 0, 0, 0, 0, 0, -1, 0, 0, -0.5, 0, 1, -0.5, 0, 1, 0;
  one << 0, 0, 0, 0, 0, -1, 0, 0, -1, 0, 1, -1, 1, 1, -1;
  for (const VectorXd& x : {fold, none, one}) {
    for (Products product : {Products::exact, Products::definite}) {
      const RestCurvature force(strand, some_rest(strand), normal, product);
      EXPECT_TRUE(std::isfinite(force.energy(x)));
      EXPECT_TRUE(force_of(force, x).allFinite());
      EXPECT_TRUE(product_of(force, x, VectorXd::LinSpaced(15, -1, 1)).allFinite());
    }
  }
  const RestCurvature force(strand, some_rest(strand), normal, Products::exact);
  EXPECT_EQ(force.energy(none), 0);
  EXPECT_EQ(force_of(force, none), VectorXd::Zero(15));
}

// H2's springs act there: see the header's energy.
TEST(RestCurvature, AtTheFoldHasTheEnergyOfAStraightStrandsJointAndThatOfItsRest) {
  Strand strand = reference_tests::test_strand(4);
  strand.clamped = true;
  const VectorXd rest = some_rest(strand);
  const RestCurvature force(strand, rest, Vector3d::UnitX(), Products::exact);
  // The second joint is folded, exactly or nearly; the third is straight or bends by a right angle.
  for (double off : {0.0, 1e-12, 1e-6, 0.05})
    for (double bend : {0.0, pi / 2}) {
      const Vector3d up(std::sin(off), 0, std::cos(off));
      VectorXd x = VectorXd::Zero(12);
      x.segment<3>(3) = -Vector3d::UnitZ();
      x.segment<3>(6) = x.segment<3>(3) + up;
      x.segment<3>(9) = x.segment<3>(6) + std::cos(bend) * up + std::sin(bend) * Vector3d::UnitY();
      const double l0 = strand.rest_length[0], l1 = strand.rest_length[1], l2 = strand.rest_length[2];
      const double EI = strand.bend_rigidity, fold = pi - off;
      const double expected = EI / l0 * rest.segment<2>(0).squaredNorm() +
                              EI / (l0 + l1) * (fold * fold + rest.segment<2>(2).squaredNorm()) +
                              EI / (l1 + l2) * (bend * bend + rest.segment<2>(4).squaredNorm());
      EXPECT_NEAR(force.energy(x), expected, 64 * kUnit * expected) << off << ", " << bend;
    }
}

// A joint closes up to the fold: the largest force and product stay within the header's bounds. Over 0.31
// radians the kept part falls to 0; it changes by at most 1.5 / 0.09 sin(phi) < 7.3 a radian, and frames turn
// by 2 / 0.14.
TEST(RestCurvature, IsBoundedUpToTheFold) {
  Strand strand = reference_tests::test_strand(6);
  strand.clamped = true;
  const RestCurvature exact(strand, some_rest(strand), Vector3d::UnitX(), Products::exact),
      spd(strand, some_rest(strand), Vector3d::UnitX(), Products::definite);
  double most_force = 0, most_product = 0;
  std::vector<double> angles = {pi - 1e-15, pi - 1e-12, pi - 1e-8, pi - 1e-4};
  for (double off = 0.01; off < 0.8; off += 0.01) angles.push_back(pi - off);
  const double k = 2 * strand.bend_rigidity / strand.rest_length.minCoeff();
  for (double phi : angles)
    for (int joint : {1, 2, 5, 9}) {  // 9: joints 1 and 2
      VectorXd x = VectorXd::Zero(18);
      Vector3d direction(0, 0, -1);
      for (int i = 0; i < 5; ++i) {
        const bool closes = i == joint || (joint == 9 && (i == 1 || i == 2));
        const Vector3d axis = direction.cross(Vector3d(0.3 * i + 0.1, 1, 0.2)).normalized();
        direction = Eigen::AngleAxisd(closes ? phi : 0.4 * i, axis) * direction;
        x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + direction;
      }
      most_force = std::max(most_force, force_of(exact, x).norm());
      const MatrixXd S = -matrix_of(spd, x);
      most_product = std::max(most_product, S.cwiseAbs().maxCoeff());
      EXPECT_LE((S - S.transpose()).cwiseAbs().maxCoeff(), 1e5 * kUnit * S.cwiseAbs().maxCoeff()) << phi;
      EXPECT_GE(eigenvalues(S).minCoeff(), -1e5 * kUnit * S.cwiseAbs().maxCoeff()) << phi;
    }
  EXPECT_LE(most_force, 5 * k * 2 * (pi + 0.71 * (2 / 0.14 + 7.3) * pi) * 2);
  EXPECT_LE(most_product, 5 * k * 4 * std::pow(1 + 2 / 0.14 + 7.3 * pi, 2));
}

TEST(RestCurvature, WhereJointsCloseAgreesWithCentralDifferences) {
  Strand strand = reference_tests::test_strand(6);
  strand.clamped = true;
  const RestCurvature force(strand, some_rest(strand), Vector3d::UnitX(), Products::exact);
  const reference_tests::ForceUnderTest f = {
      [&](const VectorXd& x) { return force.energy(x); },
      [&](const VectorXd& x) { return force_of(force, x); },
      [&](const VectorXd& x, const VectorXd& dx) { return product_of(force, x, dx); }};
  for (double off : {0.2, 0.3, 0.4}) {
    VectorXd x = VectorXd::Zero(18);
    Vector3d direction(0, 0, -1);
    for (int i = 0; i < 5; ++i) {
      const Vector3d axis = direction.cross(Vector3d(0.3 * i + 0.1, 1, 0.2)).normalized();
      direction = Eigen::AngleAxisd(i == 1 || i == 2 ? pi - off : 0.4 * i, axis) * direction;
      x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + direction;
    }
    const double k = 2 * strand.bend_rigidity / strand.rest_length.minCoeff();
    // A change of 0.09 in 1 + cos(phi) is sin(phi) times an angle of at least 0.2.
    expect_derivatives(f, x, 0.1, 5 * k * 100, 5 * k * 100 / 0.1);
  }
}

}  // namespace
}  // namespace hair
