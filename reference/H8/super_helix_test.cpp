// STAFF ONLY. H8 beyond its public checks: digits and jumps of its functions, and its sums over the points of
// given motions.

#include "hair/super_helix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/super_helix/helix_momentum.h"
#include "reference/H8/super_helices_for_tests.h"
#include "solver/dense_algebra.h"

namespace reference_tests {
namespace {

using hair::HelixJacobian, hair::MaterialFrame, hair::Matrix3d;

// ---- Stumpff's functions

// c_k by its series with 64 bits of mantissa and the terms in pairs, or by the closed form for large x.
long double exact_stumpff(int k, long double x) {
  if (x > 100) {
    long double value = k % 2 == 0 ? std::cos(std::sqrt(x)) : std::sin(std::sqrt(x)) / std::sqrt(x);
    long double factorial = 1;
    for (int m = k % 2; m < k; m += 2) {
      value = (1 / factorial - value) / x;
      factorial *= (m + 1) * (m + 2);
    }
    return value;
  }
  long double term = 1, sum = 0;
  for (int m = 2; m <= k; ++m) term /= m;
  for (int m = k; m < k + 120; m += 2) {
    sum += term;
    term *= -x / ((m + 1) * (m + 2));
  }
  return sum;
}

double bound_of_stumpff(int k, double x) {
  const double bound = 1 / std::tgamma(k + 1);
  return k < 2 || x == 0 ? bound : std::min(bound, 2 / (std::tgamma(k - 1) * x));
}

// The bound allows a rounding of 1e-13; a^2 = x is known to half a unit, so cos a to a / 2 units.
TEST(Stumpff, HasItsDigitsForAllX) {
  std::vector<double> all = {0, 1e-300, 15791.4, 1e6, 4, std::nextafter(4, 0), std::nextafter(4, 5)};
  for (double x = 1e-12; x < 1e5; x *= 1.07) all.push_back(x);
  for (const double x : all) {
    const std::array<double, 8> c = hair::stumpff(x);
    for (int k = 0; k < 8; ++k)
      EXPECT_LE(std::abs(c[k] - exact_stumpff(k, x)), (2e-14 + 2e-16 * std::sqrt(x)) * bound_of_stumpff(k, x))
          << "c_" << k << "(" << x << ") = " << c[k];
  }
}

// ---- Centre line and frame

// Across the switch at |p| = 2, and at 0, pose and Jacobian change over a step of 1e-9 as the derivative
// says, to rounding over 1e-9. A jump of 1e-12 would show.
TEST(HelixFrames, HaveNoJump) {
  const MaterialFrame start;
  const Vector3d direction = Vector3d(1, 2, 3).normalized();
  for (const double size : {0.0, 1e-8, 1e-4, 2.0}) {
    const Vector3d before = (size - 1e-10) * direction, after = (size + 1e-10) * direction;
    const MaterialFrame a = hair::frame_at(start, before, 1), b = hair::frame_at(start, after, 1);
    const HelixJacobian J = hair::jacobian_at(start, size * direction, 1);
    EXPECT_LE((b.position - a.position - J.moves * (after - before)).norm(), 3e-16) << size;
    const HelixJacobian Ja = hair::jacobian_at(start, before, 1), Jb = hair::jacobian_at(start, after, 1);
    EXPECT_LE((Jb.moves - Ja.moves).norm() + (Jb.turns - Ja.turns).norm(), 2e-10) << size;
  }
}

// ---- Forces and masses

// Twisting straight hair moves nothing: it has an eigenvalue of 0 for each torsion. Any curl moves.
TEST(HelixMass, IsSingularForStraightHairAlone) {
  for (const int elements : {1, 5, 20}) {
    HelixMotion motion(hair_strand(elements, 0.1));
    MatrixXd M(3 * elements, 3 * elements);
    motion.place({}, VectorXd::Zero(3 * elements));
    hair::mass_matrix(motion.elements, motion.points, M);
    for (int k = 2; k < 3 * elements; k += 3) EXPECT_EQ(M.col(k).norm(), 0) << "a torsion";
    const VectorXd straight = solver::symmetric_eigenvalues(M);
    EXPECT_GE(straight[0], -1e-15 * straight[3 * elements - 1]);
    EXPECT_GT(straight[elements], 0);

    VectorXd K(3 * elements);
    hair::helix_stiffness(motion.strand(), K);
    M.diagonal() += K / (30. * 30);
    EXPECT_GT(solver::symmetric_eigenvalues(M)[0], 0) << "M + h^2 K";

    const Vector3d curl(40, 30, 20);
    motion.place({}, curl.replicate(elements, 1));
    hair::mass_matrix(motion.elements, motion.points, M);
    const VectorXd curled = solver::symmetric_eigenvalues(M);
    EXPECT_GE(curled[0], -1e-15 * curled[3 * elements - 1]);
    if (elements == 1) {
      EXPECT_GT(curled[0], 1e-9 * curled[2]);
    }
  }
}

// A strand that moves as a whole in a wind has the drag - drag * length * (velocity - wind), and an implicit
// step adds to it.
TEST(HelixForces, DragIsTowardsTheWindsVelocity) {
  HelixMotion motion(hair_strand(3, 0.1));
  HelixRoot root;
  root.velocity = Vector3d(1, 2, 3);
  motion.place(root.frame, VectorXd::Constant(9, 30));
  motion.move(root, VectorXd::Zero(9));
  hair::add_drag(1e-4, Vector3d(0, 0, 5), 0.01, motion);
  Vector3d force = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();
  for (const hair::HelixPoint& point : motion.points) {
    force += point.force;
    inertia += point.inertia;
  }
  EXPECT_LE((force + 1e-5 * Vector3d(1, 2, -2)).norm(), 1e-19);
  const double mass = 0.1 * motion.strand().line_density + 0.01 * 1e-5;
  EXPECT_LE((inertia - mass * Matrix3d::Identity()).norm(), 1e-14 * mass);
}

// ---- Motion

// The places of all points while the root moves with constant accelerations and q with constant rates.
void place_later(const HelixRoot& root, const VectorXd& q, const VectorXd& rates, double t,
                 HelixMotion& motion) {
  MaterialFrame frame;
  frame.position = root.frame.position + t * root.velocity + t * t / 2 * root.acceleration;
  // To the second order: exp(t w + t^2/2 w').
  const Vector3d turn = t * root.spin + t * t / 2 * root.spin_acceleration;
  frame.axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * root.frame.axes;
  motion.place(frame, q + t * rates);
}

TEST(HelixMotions, VelocitiesAndAccelerationsAreDerivativesByTime) {
  for (const double angle : {0.0, 0.01, 1.5, 30.0}) {
    RandomNumbers numbers(8);
    HelixMotion motion(hair_strand(5, 0.1));
    const HelixRoot root = random_root(numbers);
    const VectorXd q = random_curl(motion.strand(), angle, numbers),
                   rates = random_curl(motion.strand(), 20, numbers);
    motion.place(root.frame, q);
    motion.move(root, rates);
    motion.accelerate(root, rates);
    HelixMotion before(motion.strand()), after(motion.strand());
    const double d = 1e-5;
    place_later(root, q, rates, -d, before);
    place_later(root, q, rates, d, after);
    double scale = 0;
    for (const Vector3d& a : motion.accelerations) scale = std::max(scale, a.norm());
    for (std::size_t j = 0; j < motion.points.size(); ++j) {
      ASSERT_EQ(before.points[j].s, motion.points[j].s);
      const Vector3d &a = before.points[j].position, &b = motion.points[j].position,
                     &c = after.points[j].position;
      // The bounds come from third and fourth derivatives at 100 rad/s and 1e-5 s, and from a rounding of
      // 1e-17 m / 1e-10 s^2.
      EXPECT_LE(((c - a) / (2 * d) - motion.velocities[j]).norm(), 1e-4) << angle;
      EXPECT_LE(((c - 2 * b + a) / (d * d) - motion.accelerations[j]).norm(), 1e-5 * scale) << angle;
    }
  }
}

TEST(HelixMotions, KineticEnergyIsThatOfM) {
  for (const double angle : {0.0, 1.0, 10.0, 126.0}) {
    RandomNumbers numbers(9);
    HelixMotion motion(hair_strand(3, 0.1));
    const VectorXd q = random_curl(motion.strand(), angle, numbers),
                   rates = random_curl(motion.strand(), 5, numbers);
    motion.place({}, q);
    motion.move({}, rates);
    MatrixXd M(9, 9);
    hair::mass_matrix(motion.elements, motion.points, M);
    const double energy = rates.dot(M * rates) / 2;
    EXPECT_NEAR(hair::kinetic_energy(motion), energy, 1e-13 * energy);
  }
}

TEST(HelixMotions, HavePointsAtPlaces) {
  const HelixStrand strand = hair_strand(4, 0.1);
  HelixMotion motion(strand, {0.1, 0.03, 0, 0.025, 0.026});
  const Vector3d curvature(20, 10, 5);
  motion.place({}, curvature.replicate(4, 1));
  int k = 0;
  for (const double s : {0.1, 0.03, 0.0, 0.025, 0.026}) {
    const hair::HelixPoint& point = motion.points[motion.placed[k++]];
    EXPECT_LE((point.position - hair::frame_at({}, curvature, s).position).norm(), 1e-16) << s;
    EXPECT_EQ(point.inertia.norm(), 0);
  }
  for (std::size_t j = 1; j < motion.points.size(); ++j)
    EXPECT_GE(motion.points[j].element, motion.points[j - 1].element);
}

// The quadrature gives the same M, and the same weight, with every element cut in two.
TEST(HelixMotions, IntegralsAreExactHoweverMuchAnElementWinds) {
  for (const double angle : {0.0, 0.5, 1.99, 2.01, 5.0, 60.0, 126.0}) {
    const Vector3d curvature = angle / 0.1 * Vector3d(0.48, 0.64, 0.6);
    HelixMotion whole(hair_strand(1, 0.1)), parts(hair_strand(64, 0.1));
    whole.place({}, curvature);
    parts.place({}, curvature.replicate(64, 1));
    MatrixXd M(3, 3), fine(192, 192), sum = MatrixXd::Zero(3, 3);
    hair::mass_matrix(whole.elements, whole.points, M);
    hair::mass_matrix(parts.elements, parts.points, fine);
    for (int i = 0; i < 64; ++i)
      for (int k = 0; k < 64; ++k) sum += fine.block<3, 3>(3 * i, 3 * k);
    EXPECT_LE((M - sum).norm(), 1e-12 * sum.norm()) << angle;
  }
}

}  // namespace
}  // namespace reference_tests
