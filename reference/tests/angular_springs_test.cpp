// STAFF ONLY. What hair/angular_springs.h promises.

#include "hair/angular_springs.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "hair/strand/tests/strand_states.h"
#include "handout/checks/derivative.h"
#include "reference/tests/bend.h"
#include "solver/symmetric_eigen.h"
#include "solver/tests/allocations.h"

namespace reference_tests {
namespace {

using std::numbers::pi;

ForceUnderTest bend_under_test(const Strand& strand) {
  return {[&](const VectorXd& x) { return bend_energy(strand, x); },
          [&](const VectorXd& x) { return bend_force(strand, x); },
          [&](const VectorXd& x, const VectorXd& dx) { return bend_product(strand, x, dx); }};
}

// k pi / l and k pi / l^2 of the stiffest joint, 2 EI over the shortest rest length; next to the fold divided
// by how much angle is left.
double force_scale(const StrandState& s) {
  return 2 * s.strand.bend_rigidity / s.strand.rest_length.minCoeff() * pi / s.shortest;
}
double product_scale(const StrandState& s) {
  return force_scale(s) / s.shortest / std::min(1.0, s.least_bend);
}

TEST(AngularSprings, AgreeWithCentralDifferencesInEveryState) {
  for (const StrandState& s : strand_states()) {
    SCOPED_TRACE(s.name + ", " + std::to_string(s.strand.count()) + " particles");
    // Next to the fold everything changes within pi - phi.
    const double length = s.shortest * std::min(1.0, s.least_bend);
    expect_derivatives(bend_under_test(s.strand), s.x, length, force_scale(s), product_scale(s));
  }
}

TEST(AngularSprings, LeaveLinearAndAngularMomentumAlone) {
  for (const StrandState& s : strand_states()) {
    if (s.strand.clamped) continue;  // The clamp holds root_tangent, with a torque.
    SCOPED_TRACE(s.name);
    expect_no_momentum(bend_force(s.strand, s.x), s.x, s.strand.count() * 64 * kUnit * force_scale(s));
  }
}

TEST(AngularSprings, OfAClampedStrandStillAddUpToNoForce) {
  for (const StrandState& s : strand_states()) {
    const VectorXd f = bend_force(s.strand, s.x);
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < s.strand.count(); ++i) sum += f.segment<3>(3 * i);
    EXPECT_LE(sum.norm(), s.strand.count() * 64 * kUnit * force_scale(s)) << s.name;
  }
}

TEST(AngularSprings, HaveSymmetricDerivatives) {
  for (const StrandState& s : strand_states()) {
    SCOPED_TRACE(s.name);
    // The bend's axis is known to u / sin(phi), and next to the fold that is divided by pi - phi.
    const double rounding = 256 * kUnit * product_scale(s) / std::min(1.0, s.least_bend);
    expect_symmetric_matrix(bend_matrix(s.strand, s.x), rounding);
    expect_symmetric_matrix(bend_matrix_spd(s.strand, s.x), rounding);
  }
}

TEST(AngularSprings, TurnWithARigidMotion) {
  const RigidMotion motion = some_motion();
  for (const StrandState& s : strand_states()) {
    SCOPED_TRACE(s.name);
    Strand turned = s.strand;
    turned.root_tangent = motion.rotation * s.strand.root_tangent;
    const VectorXd x = motion.points(s.x), dx = VectorXd::LinSpaced(x.size(), -1, 1);
    // Positions of a few metres round by 16 u, angles by that over the shortest segment, and what follows in
    // proportion.
    const double angle = 64 * kUnit * 4 / s.shortest, relative = angle / std::min(1.0, s.least_bend);
    EXPECT_NEAR(bend_energy(turned, x), bend_energy(s.strand, s.x),
                angle * force_scale(s) * s.strand.count());
    EXPECT_LE((bend_force(turned, x) - motion.vectors(bend_force(s.strand, s.x))).norm(),
              8 * relative * force_scale(s));
    EXPECT_LE((bend_product(turned, x, motion.vectors(dx)) - motion.vectors(bend_product(s.strand, s.x, dx)))
                  .norm(),
              64 * relative * product_scale(s));
  }
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

TEST(AngularSprings, HaveTheEigenvalueMinusPhiTanHalfPhi) {
  const double EI = 1.47e-8, l = 0.01, k = EI / (l * l * l);
  for (double phi : {0.01, 0.2, 1.0, 2.0, 3.0}) {
    const StrandState s = one_joint(l, phi, EI);
    VectorXd ends = VectorXd::Zero(9);
    ends[1] = 1;
    ends[7] = -1;
    const VectorXd minus = -bend_product(s.strand, s.x, ends), expected = -k * phi * std::tan(phi / 2) * ends;
    EXPECT_LE((minus - expected).norm(), 256 * kUnit * k * pi / std::sin(phi)) << "phi = " << phi;
  }
}

TEST(AngularSprings, AreSemidefiniteInTheirSecondProduct) {
  for (const StrandState& s : strand_states()) {
    const MatrixXd S = -bend_matrix_spd(s.strand, s.x);
    const VectorXd eigenvalues = solver::symmetric_eigenvalues(S);
    EXPECT_GE(eigenvalues.minCoeff(), -64 * kUnit * static_cast<double>(S.rows()) * S.cwiseAbs().maxCoeff())
        << s.name;
  }
}

TEST(AngularSprings, HaveASecondProductThatIsExactWhereTheyAreStraight) {
  for (const StrandState& s : strand_states()) {
    if (s.name.find("collinear") == std::string::npos && s.name.find("at rest") == std::string::npos)
      continue;
    SCOPED_TRACE(s.name);
    EXPECT_LE((bend_matrix_spd(s.strand, s.x) - bend_matrix(s.strand, s.x)).cwiseAbs().maxCoeff(),
              256 * kUnit * product_scale(s));
  }
}

TEST(AngularSprings, HaveASecondProductThatApproachesTheExactOneWithTheBend) {
  // What is left out is of first order in phi: phi tan(phi/2) and what the turning of forces makes, k phi.
  for (double phi : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-14}) {
    const StrandState s = one_joint(0.7, phi, 4);
    const MatrixXd difference = bend_matrix_spd(s.strand, s.x) - bend_matrix(s.strand, s.x);
    const double k = 4 / 0.7 / (0.7 * 0.7);
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), k * (8 * phi + 256 * kUnit)) << "phi = " << phi;
  }
}

TEST(AngularSprings, HaveASecondProductThatIsTheFormula) {
  for (double phi : {1e-3, 0.4, 1.5, 1.7, 3.0}) {
    const StrandState s = one_joint(0.7, phi, 4);
    const Vector3d e1 = s.x.segment<3>(3), e2 = s.x.segment<3>(6) - e1, b = e1.cross(e2).normalized();
    const Vector3d first = -b.cross(e1) / e1.squaredNorm(), second = b.cross(e2) / e2.squaredNorm();
    VectorXd gradient(9), g(9);
    gradient << -first, first - second, second;
    g << b / e1.norm(), -b / e1.norm() - b / e2.norm(), b / e2.norm();
    const double k = 4 / 0.7;
    const MatrixXd expected =
        -k * (gradient * gradient.transpose() + std::max(phi / std::tan(phi), 0.0) * g * g.transpose());
    EXPECT_LE((bend_matrix_spd(s.strand, s.x) - expected).cwiseAbs().maxCoeff(),
              64 * kUnit * k * pi / (0.49 * std::sin(phi)))
        << "phi = " << phi;
  }
}

TEST(AngularSprings, OfTheLecturesCircleHaveItsEnergy) {
  const double R = 0.2, EI = 4;
  for (int n : {8, 16, 32, 64}) {
    const Strand strand = circle_strand(n, R, EI);
    const VectorXd x = circle(n, R);
    const double phi = 2 * pi / n, l = strand.rest_length[0];
    // n + 1 segments, the last on the first: n joints.
    EXPECT_NEAR(bend_energy(strand, x), n * EI / l * phi * phi / 2, 64 * kUnit * n * n * pi * EI / R) << n;
    // The segments are chords, 2 R sin(pi/n): a little shorter than the arcs, pi^2 / 6n^2 of them.
    EXPECT_NEAR(bend_energy(strand, x) / (pi * EI / R) - 1, pi * pi / (6 * n * n), 2 / std::pow(n, 4) * 2)
        << n;
  }
}

TEST(AngularSprings, KeepSmallAngles) {
  for (double phi : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12}) {
    // The segments are (0, 0, -1) and (0, phi, -1), exactly.
    Strand strand = test_strand(3);
    strand.rest_length.setOnes();
    VectorXd x(9);
    x << 0, 0, 0, 0, 0, -1, 0, phi, -2;
    const double exact = std::atan(phi);
    EXPECT_NEAR(bend_energy(strand, x), 2 * exact * exact, 32 * kUnit * phi * (phi + kUnit)) << phi;
    EXPECT_NEAR(bend_force(strand, x)[1], -4 * exact, 32 * kUnit * (phi + kUnit)) << phi;
  }
}

TEST(AngularSprings, AreFiniteAtTheFoldAndNextToIt) {
  StrandState s = one_joint(0.5, 0, 4);
  s.x.tail<3>().setZero();  // back to where the first segment began
  const VectorXd dx = VectorXd::LinSpaced(9, -1, 1);
  const double k = 4 / 0.5;
  EXPECT_NEAR(bend_energy(s.strand, s.x), k * pi * pi / 2, 16 * kUnit * k * pi * pi);
  EXPECT_EQ(bend_force(s.strand, s.x), VectorXd::Zero(9));
  EXPECT_EQ(bend_product(s.strand, s.x, dx), VectorXd::Zero(9));
  EXPECT_EQ(bend_product_spd(s.strand, s.x, dx), VectorXd::Zero(9));
  for (double off : {1e-3, 1e-6, 1e-12, 1e-15, 1e-100}) {
    s.x[6] = off;
    const VectorXd f = bend_force(s.strand, s.x);
    EXPECT_NEAR(f.tail<3>().norm(), k * pi / 0.5, k * pi / 0.5 * (off + 16 * kUnit))
        << "off by " << off << " m";
    EXPECT_TRUE(bend_product(s.strand, s.x, dx).allFinite()) << off;
    EXPECT_TRUE(bend_product_spd(s.strand, s.x, dx).allFinite()) << off;
  }
}

TEST(AngularSprings, IgnoreSegmentsWithoutLength) {
  const VectorXd dx = VectorXd::LinSpaced(12, -1, 1);
  for (int which : {0, 1, 2}) {
    StrandState s = strand_states()[0];
    Strand strand = test_strand(4);
    strand.clamped = true;
    VectorXd x(12);
    x << 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1;
    x.segment<3>(3 * which + 3) = x.segment<3>(3 * which);
    EXPECT_TRUE(std::isfinite(bend_energy(strand, x))) << which;
    EXPECT_TRUE(bend_force(strand, x).allFinite()) << which;
    EXPECT_TRUE(bend_product(strand, x, dx).allFinite()) << which;
    EXPECT_TRUE(bend_product_spd(strand, x, dx).allFinite()) << which;
  }
  const Strand strand = test_strand(4);
  const VectorXd x = VectorXd::Ones(12);
  EXPECT_EQ(bend_energy(strand, x), 0);
  EXPECT_EQ(bend_force(strand, x), VectorXd::Zero(12));
  EXPECT_EQ(bend_product(strand, x, dx), VectorXd::Zero(12));
  EXPECT_EQ(bend_product_spd(strand, x, dx), VectorXd::Zero(12));
}

TEST(AngularSprings, StayFiniteFromTheSmallestLengthsToTheLargest) {
  const VectorXd dx = VectorXd::LinSpaced(21, -1, 1);
  for (double scale : {1e-100, 1e-30, 1e30, 1e100}) {
    const StrandState s = strand_states()[16];
    ASSERT_EQ(s.strand.count(), 7);
    const VectorXd x = scale * s.x;
    EXPECT_TRUE(std::isfinite(bend_energy(s.strand, x))) << scale;
    EXPECT_TRUE(bend_force(s.strand, x).allFinite()) << scale;
    EXPECT_TRUE(bend_product(s.strand, x, dx).allFinite()) << scale;
    EXPECT_TRUE(bend_product_spd(s.strand, x, dx).allFinite()) << scale;
  }
}

TEST(AngularSprings, OfOneOrTwoParticlesOnAHingeAreNothing) {
  for (int count : {1, 2}) {
    const Strand strand = test_strand(count);
    const VectorXd x = VectorXd::LinSpaced(3 * count, 0, 1), zero = VectorXd::Zero(3 * count);
    EXPECT_EQ(bend_energy(strand, x), 0);
    EXPECT_EQ(bend_force(strand, x), zero);
    EXPECT_EQ(bend_product(strand, x, x), zero);
    EXPECT_EQ(bend_product_spd(strand, x, x), zero);
  }
}

TEST(AngularSprings, OfAClampedParticleAreNothing) {
  Strand strand = test_strand(1);
  strand.clamped = true;
  const VectorXd x = VectorXd::Ones(3);
  EXPECT_EQ(bend_energy(strand, x), 0);
  EXPECT_EQ(bend_force(strand, x), VectorXd::Zero(3));
}

TEST(AngularSprings, ServeTenThousandParticles) {
  Strand strand = test_strand(10000);
  VectorXd x(30000);
  for (int i = 0; i < x.size(); ++i) x[i] = std::sin(1.0 * i * i);
  EXPECT_TRUE(std::isfinite(bend_energy(strand, x)));
  EXPECT_TRUE(bend_force(strand, x).allFinite());
  EXPECT_TRUE(bend_product(strand, x, x).allFinite());
  EXPECT_LT(x.dot(bend_product_spd(strand, x, x)), 0);
}

TEST(AngularSprings, AllocateNothing) {
  const StrandState s = strand_states()[2];
  VectorXd out = VectorXd::Zero(s.x.size());
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  bend_energy(s.strand, s.x);
  add_bend_force(s.strand, s.x, out);
  add_bend_product(s.strand, s.x, s.x, out);
  add_bend_product_spd(s.strand, s.x, s.x, out);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace reference_tests
