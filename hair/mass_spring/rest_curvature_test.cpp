// STAFF ONLY. The promises of hair/mass_spring/rest_curvature.h, also for joints near the fold, and for
// segments without a direction.
#include "hair/mass_spring/rest_curvature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/angular_springs.h"
#include "hair/mass_spring/dual.h"
#include "hair/mass_spring/test_rest_curvature_cases.h"
#include "hair/strand/make_strand.h"
#include "hair/strand/rest_shape.h"
#include "hair/stretch_springs.h"

namespace hair {
namespace {

TEST(DualNumbers, AreValuesWithTheirDerivatives) {
  const double x = 0.7;
  auto f = [](auto a) {
    using std::atan2, std::sqrt;
    return sqrt(a * a + decltype(a)(2.0)) / (decltype(a)(3.0) - a) - atan2(a, -a * a);
  };
  const Dual y = f(Dual(x, 1));
  EXPECT_NEAR(y.value, f(x), 4 * kUnit * 4);
  const double h = 0x1p-13;
  const double slope = (4 * (f(x + h / 2) - f(x - h / 2)) / h - (f(x + h) - f(x - h)) / (2 * h)) / 3;
  EXPECT_NEAR(y.change, slope, 1e-11) << "bound: 8 u over the step, 2^-13";
}

TEST(RestCurvature, AgreesWithCentralDifferencesInEveryState) {
  for (const StrandState& s : clamped_states()) {
    SCOPED_TRACE(s.name + ", " + std::to_string(s.strand.count()) + " particles");
    const RestCurvature force(s.strand, some_rest(s.strand), some_normal(s.strand.root_tangent),
                              Products::exact);
    const reference_tests::ForceUnderTest f = {
        [&](const VectorXd& x) { return force.energy(x); },
        [&](const VectorXd& x) { return force_of(force, x); },
        [&](const VectorXd& x, const VectorXd& dx) { return product_of(force, x, dx); }};
    const Scales scales(s);
    expect_derivatives(f, s.x, s.shortest * std::min(1.0, s.least_bend), scales.force, scales.product);
  }
}

TEST(RestCurvature, OfStraightHairIsThatOfAngularSprings) {
  for (const StrandState& s : clamped_states()) {
    SCOPED_TRACE(s.name);
    const RestCurvature force(s.strand, VectorXd::Zero(2 * s.strand.segments()),
                              some_normal(s.strand.root_tangent), Products::exact);
    VectorXd f = VectorXd::Zero(s.x.size()), df = f;
    const VectorXd dx = VectorXd::LinSpaced(s.x.size(), -1, 1);
    add_bend_force(s.strand, s.x, f);
    add_bend_product(s.strand, s.x, dx, df);
    const Scales scales(s);
    EXPECT_NEAR(force.energy(s.x), bend_energy(s.strand, s.x), 64 * kUnit * scales.energy);
    EXPECT_LE((force_of(force, s.x) - f).norm(), 64 * kUnit * scales.force);
    EXPECT_LE((product_of(force, s.x, dx) - df).norm(),
              256 * kUnit * scales.product / std::min(1.0, s.least_bend));
  }
}

TEST(RestCurvature, IsAtRestInItsRestShape) {
  for (const RestShape& shape : {straight_shape(30, 0.3, {}), wavy_shape(30, 0.3, 0.01, 0.08, {}),
                                 curly_shape(30, 0.3, 0.01, 0.02, {})}) {
    Strand strand = strand_from_rest({}, shape.x);
    strand.clamped = true;
    strand.root_tangent = shape.tangent;
    const VectorXd rest = bend_components(shape.x, shape.tangent, shape.normal);
    const RestCurvature force(strand, rest, shape.normal, Products::exact);
    EXPECT_EQ(force.energy(shape.x), 0);
    EXPECT_EQ(force_of(force, shape.x), VectorXd::Zero(shape.x.size()));
    // Moved by 1 um, the strand is not at rest.
    VectorXd moved = shape.x;
    moved[45] += 1e-6;
    EXPECT_GT(force.energy(moved), 0);
  }
}

TEST(RestCurvature, TurnsWithItsRootFrame) {
  const reference_tests::RigidMotion motion = reference_tests::some_motion();
  for (const StrandState& s : clamped_states()) {
    if (s.name.starts_with("nearly folded")) continue;  // turned, a fold of 1e-3 differs by 1e-12
    SCOPED_TRACE(s.name);
    const Vector3d normal = some_normal(s.strand.root_tangent);
    Strand turned = s.strand;
    turned.root_tangent = motion.rotation * s.strand.root_tangent;
    const RestCurvature before(s.strand, some_rest(s.strand), normal, Products::exact),
        after(turned, some_rest(s.strand), motion.rotation * normal, Products::exact);
    const VectorXd x = motion.points(s.x);
    const Scales scales(s);
    const double relative =
        64 * kUnit * 4 / s.shortest;  // positions of a few metres round, and angles with them
    EXPECT_NEAR(after.energy(x), before.energy(s.x), relative * scales.energy);
    EXPECT_LE((force_of(after, x) - motion.vectors(force_of(before, s.x))).norm(), relative * scales.force);
  }
}

TEST(RestCurvature, FeelsItsRootTurnAboutItself) {
  const RestShape shape = curly_shape(20, 0.2, 0.01, 0.02, {});
  Strand strand = strand_from_rest({}, shape.x);
  strand.clamped = true;
  strand.root_tangent = shape.tangent;
  RestCurvature force(strand, bend_components(shape.x, shape.tangent, shape.normal), shape.normal,
                      Products::exact);
  force.set_root_normal(shape.tangent.cross(shape.normal));
  EXPECT_GT(force.energy(shape.x), 0);
  EXPECT_GT(force_of(force, shape.x).norm(), 0);
}

TEST(RestCurvature, HasSymmetricProducts) {
  for (const StrandState& s : clamped_states()) {
    for (Products product : {Products::exact, Products::definite}) {
      const RestCurvature force(s.strand, some_rest(s.strand), some_normal(s.strand.root_tangent), product);
      SCOPED_TRACE(s.name);
      reference_tests::expect_symmetric_matrix(matrix_of(force, s.x),
                                               256 * kUnit * Scales(s).product / std::min(1.0, s.least_bend));
    }
  }
}

TEST(RestCurvature, HasASemidefiniteProductThatIsExactAtRest) {
  for (const StrandState& s : clamped_states()) {
    SCOPED_TRACE(s.name);
    const RestCurvature force(s.strand, some_rest(s.strand), some_normal(s.strand.root_tangent),
                              Products::definite);
    const MatrixXd S = -matrix_of(force, s.x);
    EXPECT_GE(eigenvalues(S).minCoeff(),
              -64 * kUnit * static_cast<double>(S.rows()) * S.cwiseAbs().maxCoeff());

    if (s.name.starts_with("nearly folded")) continue;  // hair may not rest in this shape
    const VectorXd rest = bend_components(s.x, s.strand.root_tangent, some_normal(s.strand.root_tangent));
    const RestCurvature exact(s.strand, rest, some_normal(s.strand.root_tangent), Products::exact),
        spd(s.strand, rest, some_normal(s.strand.root_tangent), Products::definite);
    EXPECT_LE((matrix_of(exact, s.x) - matrix_of(spd, s.x)).cwiseAbs().maxCoeff(),
              256 * kUnit * Scales(s).product / std::min(1.0, s.least_bend));
  }
}

// The stiff parts of a helix whose root is clamped: springs along it and its curvature.
struct Helix {
  RestShape shape;
  Strand strand;
};
Helix helix(int segments) {
  Helix result{curly_shape(segments, 0.2, 0.01, 0.02, {}), {}};
  result.strand = strand_from_rest({}, result.shape.x);
  result.strand.clamped = true;
  result.strand.root_tangent = result.shape.tangent;
  return result;
}

MatrixXd stretch_matrix(const Strand& strand, const VectorXd& x) {
  return reference_tests::matrix_of(
      [&](const VectorXd& dx) {
        VectorXd df = VectorXd::Zero(x.size());
        add_stretch_product(strand, x, GeometricTerm::full, dx, df);
        return df;
      },
      x.size());
}

TEST(RestCurvature, LeavesAClampedHelixNoZeroEnergyMode) {
  for (int segments : {16, 24, 48}) {
    const auto [shape, strand] = helix(segments);
    const RestCurvature force(strand, bend_components(shape.x, shape.tangent, shape.normal), shape.normal,
                              Products::exact);
    const int free = 3 * segments;
    const VectorXd all = eigenvalues(
        -(matrix_of(force, shape.x) + stretch_matrix(strand, shape.x)).bottomRightCorner(free, free));
    // The softest motion of this hair is a straight beam's bending in its first mode: 1.875^4 = 12.36 EI /
    // L^4 per metre, and so 12.36 EI / (n L^3) for each particle. A helix is shorter, and stiffer.
    const double L = strand.rest_length.sum(),
                 softest = 12.36 * strand.bend_rigidity / (segments * L * L * L);
    EXPECT_GE(all.minCoeff(), softest) << segments << " segments";
    EXPECT_GE(all.minCoeff(), 100 * kUnit * all.maxCoeff()) << "far above what the largest one rounds by";
  }
}

TEST(RestCurvature, DoesNotDependOnTheSampling) {
  // A helix, straightened: E = EI/2 kappa^2 L, to second order.
  std::vector<double> errors;
  const double r = 0.01, c = 0.02 / (2 * pi), kappa = r / (r * r + c * c);
  for (int segments : {24, 48, 96, 192}) {
    const auto [shape, strand] = helix(segments);
    const RestCurvature force(strand, bend_components(shape.x, shape.tangent, shape.normal), shape.normal,
                              Products::exact);
    VectorXd x = VectorXd::Zero(shape.x.size());
    for (int i = 0; i < segments; ++i)
      x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + strand.rest_length[i] * shape.tangent;
    const double exact = strand.bend_rigidity / 2 * kappa * kappa * 0.2;
    // No joint stores the last half segment's bend.
    errors.push_back(std::abs(force.energy(x) / exact + 0.5 / segments - 1));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(errors[i - 1] / errors[i], 4, 0.8) << i;
}

TEST(RestCurvature, ServesTenThousandParticles) {
  const RestShape shape = curly_shape(9999, 10, 0.01, 0.02, {});
  Strand strand = strand_from_rest({}, shape.x);
  strand.clamped = true;
  strand.root_tangent = shape.tangent;
  const RestCurvature force(strand, bend_components(shape.x, shape.tangent, shape.normal), shape.normal,
                            Products::definite);
  VectorXd x = shape.x;
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += 1e-5 * std::sin(static_cast<double>(i * i));
  EXPECT_TRUE(force_of(force, x).allFinite());
  EXPECT_LT(x.dot(product_of(force, x, x)), 0);
}

TEST(RestCurvature, RefusesWhatMakesNoSense) {
  Strand strand = reference_tests::test_strand(4);
  const VectorXd rest = VectorXd::Zero(6);
  const Vector3d normal(1, 0, 0);
  EXPECT_THROW(RestCurvature(strand, rest, normal, Products::exact), std::invalid_argument) << "not clamped";
  strand.clamped = true;
  EXPECT_NO_THROW(RestCurvature(strand, rest, normal, Products::exact));
  EXPECT_THROW(RestCurvature(strand, VectorXd::Zero(4), normal, Products::exact), std::invalid_argument);
  EXPECT_THROW(RestCurvature(strand, rest, Vector3d(0, 0, 1), Products::exact), std::invalid_argument);
  EXPECT_THROW(RestCurvature(strand, rest, Vector3d(2, 0, 0), Products::exact), std::invalid_argument);
  EXPECT_THROW(bend_components(VectorXd::Ones(9), Vector3d::UnitZ(), normal), std::invalid_argument);
  EXPECT_THROW(bend_components(VectorXd::Ones(4), Vector3d::UnitZ(), normal), std::invalid_argument);
}

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
