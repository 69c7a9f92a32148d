// The public checks of H8, piece by piece: first what every element needs, then sums over the strand with
// elements that are made here, then the step. Every failure prints the input, what was expected, what came,
// the error and its bound. The contract is in hair/super_helix.h.

#include "hair/super_helix.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <set>

#include "check.h"
#include "derivative.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using hair::HelixElement, hair::HelixJacobian, hair::HelixPoint, hair::HelixStrand, hair::MaterialFrame,
    hair::Matrix3d, hair::Vector3d;

namespace {

constexpr double kPi = std::numbers::pi;

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

// A root that is not at 0 and looks in no special direction.
MaterialFrame some_root() {
  return {Vector3d(0.1, -0.2, 0.3), Eigen::AngleAxisd(2, Vector3d(2, -1, 2).normalized()).toRotationMatrix()};
}

const Vector3d kCurvature(1.2, -0.7, 0.9);  // 1/m: an element of 1 m winds by 1.66
const char* const kAxes[] = {"n1", "n2", "t"};
const char* const kCoordinates[] = {"kappa1", "kappa2", "tau"};

// ---- Strands for sums have straight elements, each in a direction of its own, so that their Jacobians are
// known. Sums don't need frames that fit together.

struct Lying {
  std::vector<HelixElement> elements;
  std::vector<HelixPoint> points;
};

// The Jacobian of a straight element, whose rates bend it about n1 and n2, and twist it. The columns of
// `moves` are n1 x t and n2 x t times s^2 / 2, and 0.
HelixJacobian straight(const Matrix3d& axes, double s) {
  HelixJacobian J;
  J.turns = s * axes;
  J.moves.col(0) = -s * s / 2 * axes.col(1);
  J.moves.col(1) = s * s / 2 * axes.col(0);
  return J;
}

// Three nodes of Gauss: exact for polynomials up to s^5, and M's integrand is s^4 here.
void add_element(const Matrix3d& axes, double length, double line_density, Lying& lying) {
  HelixElement element;
  element.length = length;
  if (!lying.elements.empty()) element.start.position = lying.elements.back().end.position;
  element.start.axes = element.end.axes = axes;
  element.end.position = element.start.position + length * axes.col(2);
  element.at_end = straight(axes, length);
  lying.elements.push_back(element);
  for (const auto& [at, weight] :
       {std::pair{-std::sqrt(0.6), 5.0 / 9}, {0.0, 8.0 / 9}, {std::sqrt(0.6), 5.0 / 9}}) {
    HelixPoint point;
    point.element = static_cast<int>(lying.elements.size()) - 1;
    point.s = (1 + at) / 2 * length;
    point.position = element.start.position + point.s * axes.col(2);
    point.moves = straight(axes, point.s).moves;
    point.inertia.diagonal().setConstant(line_density * weight * length / 2);
    lying.points.push_back(point);
  }
}

Lying straight_strand(int elements, double length, double line_density) {
  Lying lying;
  for (int i = 0; i < elements; ++i)
    add_element(Matrix3d::Identity(), length / elements, line_density, lying);
  return lying;
}

// A strand with corners at every joint, forces on all points, and points that resist more in one direction.
Lying crooked_strand() {
  Lying lying;
  for (int i = 0; i < 4; ++i) {
    const Vector3d axis = Vector3d(1, 0.5 * i, -0.3 * i * i).normalized();
    add_element(Eigen::AngleAxisd(0.4 + i, axis).toRotationMatrix(), 0.5 + 0.3 * (i % 3), 2, lying);
  }
  for (std::size_t j = 0; j < lying.points.size(); ++j) {
    const VectorXd numbers = scattered_vector(6, static_cast<int>(j));
    lying.points[j].force = numbers.head<3>();
    if (j % 2 == 0) lying.points[j].inertia += numbers.tail<3>() * numbers.tail<3>().transpose();
  }
  return lying;
}

// The velocities of all points at these rates, without J: from the root to the tip each element turns and
// carries those after it.
std::vector<Vector3d> velocities(const Lying& lying, const VectorXd& rates) {
  std::vector<Vector3d> found;
  Vector3d velocity = Vector3d::Zero(), spin = Vector3d::Zero();
  for (std::size_t i = 0; i < lying.elements.size(); ++i) {
    const HelixElement& element = lying.elements[i];
    const Vector3d rate = rates.segment<3>(3 * i);
    for (const HelixPoint& point : lying.points)
      if (point.element == static_cast<int>(i))
        found.push_back(velocity + spin.cross(point.position - element.start.position) + point.moves * rate);
    velocity += spin.cross(element.end.position - element.start.position) + element.at_end.moves * rate;
    spin += element.at_end.turns * rate;
  }
  return found;
}

HelixStrand strand_of(const Lying& lying) {
  HelixStrand strand;
  const auto n = static_cast<Eigen::Index>(lying.elements.size());
  strand.lengths.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) strand.lengths[i] = lying.elements[i].length;
  strand.line_density = 2;
  strand.bend_rigidity = 3;
  strand.twist_rigidity = 1.5;
  strand.natural = scattered_vector(static_cast<int>(3 * n), 5);
  return strand;
}

// ---- Calls, with junk where results go

VectorXd stiffness_of(const HelixStrand& strand) {
  VectorXd K = VectorXd::Constant(strand.natural.size(), 1e3);
  helix_stiffness(strand, K);
  return K;
}

VectorXd elastic_of(const HelixStrand& strand, const VectorXd& q) {
  VectorXd force = VectorXd::Constant(q.size(), 1e3);
  elastic_force(strand, q, force);
  return force;
}

// A copy has no room behind its last point, so that sanitizers find a read there.
using Points = std::vector<HelixPoint>;

VectorXd force_of(const Lying& lying) {
  VectorXd Q = VectorXd::Constant(static_cast<Eigen::Index>(3 * lying.elements.size()), 1e3);
  generalised_force(lying.elements, Points(lying.points), Q);
  return Q;
}

MatrixXd mass_of(const Lying& lying) {
  const auto size = static_cast<Eigen::Index>(3 * lying.elements.size());
  MatrixXd M = MatrixXd::Constant(size, size, 1e3);
  mass_matrix(lying.elements, Points(lying.points), M);
  return M;
}

VectorXd step_of(const HelixStrand& strand, const Lying& lying, const VectorXd& q, const VectorXd& rates,
                 double h) {
  MatrixXd scratch = MatrixXd::Constant(q.size(), q.size() + 10, 1e3);
  VectorXd change = VectorXd::Constant(q.size(), 1e3);
  helix_step(strand, lying.elements, Points(lying.points), q, rates, h, scratch, change);
  return change;
}

}  // namespace

// ---- (1)

TEST(Functions, IsWhatTheTextbookHas) {
  for (const double a : {1.0, 5.0}) {
    const double x = a * a;
    const std::array<double, 8> c = hair::stumpff(x);
    double expected[8] = {std::cos(a), std::sin(a) / a}, factorial = 1;
    for (int k = 0; k < 8; ++k) {
      if (k > 1) factorial *= k > 2 ? k - 2 : 1;
      if (k > 1) expected[k] = (1 / factorial - expected[k - 2]) / x;
      EXPECT_NUMBER(c[k], expected[k], 2e-11 / std::tgamma(k + 1))
          << "c_" << k << "(" << x << "): cos(a), sin(a) / a, and c_(k+2) = (1/k! - c_k) / x, where a is "
          << a;
    }
  }
}

TEST(NearlyStraight, IsFiniteAtZero) {
  const std::array<double, 8> c = hair::stumpff(0);
  for (int k = 0; k < 8; ++k)
    EXPECT_TRUE(std::isfinite(c[k])) << "c_" << k << "(0) is " << c[k] << ". Is there a division by x?";
}

TEST(NearlyStraight, IsOneOverKFactorialAtZero) {
  const std::array<double, 8> c = hair::stumpff(0);
  for (int k = 0; k < 8; ++k) EXPECT_NUMBER(c[k], 1 / std::tgamma(k + 1), 1e-15) << "c_" << k << "(0) = 1/k!";
}

// The functions belong together: x c_(k+2) = 1/k! - c_k, and the derivative. A jump, or digits that are lost
// near 0, break it.
TEST(NearlyStraight, KeepsItsDigitsNearZero) {
  double factorial[8] = {1};
  for (int k = 1; k < 8; ++k) factorial[k] = k * factorial[k - 1];
  for (double x = 1e-12; x < 2e4; x *= 3) {
    const std::array<double, 8> c = hair::stumpff(x);
    for (int k = 0; k < 8; ++k) {
      // Three terms are right to x^3 / (k + 6)!, and that is little below 1e-3.
      if (x < 1e-3) {
        const double one = x / ((k + 1) * (k + 2)), two = one * x / ((k + 3) * (k + 4));
        EXPECT_NUMBER(c[k] * factorial[k], 1 - one + two, 2e-12 + x * x * x)
            << "c_" << k << "(" << x
            << ") k!: the first three terms of the series. Where does the closed form begin?";
      }
      if (k < 6) {
        EXPECT_NUMBER(x * c[k + 2] + c[k], 1 / factorial[k], 3e-11 / factorial[k])
            << "x c_" << k + 2 << " + c_" << k << " = 1/" << k << "! at x = " << x;
      }
    }
    const double h = 1e-5 * x;
    if (x > 1e-3 && x < 100) {
      const std::array<double, 8> ahead = hair::stumpff(x + h), behind = hair::stumpff(x - h);
      for (int k = 1; k < 6; ++k)
        EXPECT_NUMBER((ahead[k] - behind[k]) / (2 * h), (k * c[k + 2] - c[k + 1]) / 2,
                      1e-11 / (factorial[k] * h) + 1e-9)
            << "dc_" << k << "/dx = (k c_(k+2) - c_(k+1)) / 2 at x = " << x;
    }
  }
}

// ---- (2)

TEST(CentreLine, BendsAboutN1AndN2) {
  // kappa1 turns the frame about n1: t goes from z towards -y. A circle of 0.5 m, a radian of it.
  const MaterialFrame first = hair::frame_at({}, Vector3d(2, 0, 0), 0.5);
  expect_entries(first.position, Vector3d(0, -(1 - std::cos(1)) / 2, std::sin(1) / 2), 1e-14,
                 "the point at 0.5 m of an arc with kappa1 = 2 / m");
  expect_entries(first.axes.col(2), Vector3d(0, -std::sin(1), std::cos(1)), 1e-14, "its tangent");
  const MaterialFrame second = hair::frame_at({}, Vector3d(0, 2, 0), 0.5);
  expect_entries(second.position, Vector3d((1 - std::cos(1)) / 2, 0, std::sin(1) / 2), 1e-14,
                 "the point at 0.5 m of an arc with kappa2 = 2 / m");
  const MaterialFrame third = hair::frame_at({}, Vector3d(0, 0, 2), 0.5);
  expect_entries(third.position, Vector3d(0, 0, 0.5), 1e-14, "the point at 0.5 m of a line with tau = 2 / m");
  expect_entries(third.axes.col(0), Vector3d(std::cos(1), std::sin(1), 0), 1e-14, "its n1");
}

TEST(CentreLine, GoesOnFromItsStart) {
  const MaterialFrame root = some_root(), alone = hair::frame_at({}, kCurvature, 0.7),
                      end = hair::frame_at(root, kCurvature, 0.7);
  expect_entries(end.position, root.position + root.axes * alone.position, 1e-13,
                 "the point at 0.7 m, compared with start.position + start.axes (the same of a start at 0)");
  expect_matrix(end.axes, root.axes * alone.axes, 1e-13,
                "the frame at 0.7 m, compared with start.axes (the same of a start at 0)");
}

namespace {

// dr/ds = t, dn/ds = Omega x n.
void expect_turns_by_omega(std::initializer_list<double> sizes) {
  const MaterialFrame root = some_root();
  const double h = 1e-5;
  for (const double size : sizes) {
    const Vector3d curvature = size * kCurvature;
    const MaterialFrame here = hair::frame_at(root, curvature, 0.7),
                        ahead = hair::frame_at(root, curvature, 0.7 + h),
                        behind = hair::frame_at(root, curvature, 0.7 - h);
    const Vector3d omega = here.axes * curvature;
    const double bound = 1e-10 * (1 + std::pow(2 * size, 3)) + 1e-10;
    const std::string source = "central differences over 1e-5 m",
                      of = ", |curvature| = " + number(curvature.norm());
    expect_entries((ahead.position - behind.position) / (2 * h), here.axes.col(2), bound, "dr/ds = t" + of,
                   source);
    for (int k = 0; k < 3; ++k)
      expect_entries((ahead.axes.col(k) - behind.axes.col(k)) / (2 * h),
                     omega.cross(Vector3d(here.axes.col(k))), bound,
                     std::string("d/ds of ") + kAxes[k] + " = Omega x it" + of, source);
  }
}

}  // namespace

TEST(CentreLine, TurnsByOmega) {
  expect_turns_by_omega({0.1, 1, 2});
}

TEST(NearlyStraight, IsStraightWithoutCurvature) {
  const MaterialFrame root = some_root();
  for (const double size : {0.0, 1e-12, 1e-7}) {
    const MaterialFrame end = hair::frame_at(root, size * kCurvature, 0.5);
    expect_entries(end.position, root.position + 0.5 * root.axes.col(2), 1e-12 + size,
                   "the point at 0.5 m with curvatures of " + number(size) + " / m",
                   "1e-12, and the curvature");
    expect_entries(end.axes.col(0), root.axes.col(0), 1e-12 + 2 * size, "its n1", "1e-12, and the curvature");
  }
}

// An arc about n1, however little it winds and however long it is: there is no size below which an element is
// straight.
TEST(NearlyStraight, BendsHoweverLittle) {
  for (const double length : {1.0, 1e-9, 1e9})
    for (const double angle : {1e-9, 1e-7, 1e-5, 1e-3, 0.1}) {
      const MaterialFrame end = hair::frame_at({}, Vector3d(angle / length, 0, 0), length);
      const double half = std::sin(angle / 2), across = -2 * half * half / angle;
      const std::string of = " of an arc of " + number(length) + " m that winds by " + number(angle);
      EXPECT_NUMBER(end.position.y() / length, across, 1e-10) << "y of the end, over the length," << of;
      EXPECT_NUMBER(end.axes(1, 2), -std::sin(angle), 1e-10) << "y of the tangent at the end" << of;
    }
}

// Twice around, and almost 20 times.
TEST(Winding, TurnsByOmegaManyTimes) {
  expect_turns_by_omega({10, 100});
}

// ---- (2), along the strand

TEST(CarriedFrames, GoOnWhereTheElementBeforeEnds) {
  std::vector<HelixElement> elements(3);
  for (int i = 0; i < 3; ++i) {
    elements[i].length = 0.5 + 0.2 * i;
    elements[i].curvature = (i + 1) * kCurvature;
    elements[i].start.position.setConstant(7);  // junk
    elements[i].end.axes.setConstant(7);
  }
  const MaterialFrame root = some_root();
  carry_frames(root, elements);
  ASSERT_EQ(elements.size(), 3u);
  MaterialFrame expected = root;
  for (int i = 0; i < 3; ++i) {
    const std::string of = " of element " + std::to_string(i) + " of 3";
    expect_entries(elements[i].start.position, expected.position, 1e-12, "the start" + of);
    expect_matrix(elements[i].start.axes, expected.axes, 1e-12, "the frame at the start" + of);
    expected = hair::frame_at(expected, elements[i].curvature, elements[i].length);
    expect_entries(elements[i].end.position, expected.position, 1e-12, "the end" + of);
    expect_matrix(elements[i].end.axes, expected.axes, 1e-12, "the frame at the end" + of);
  }
}

// Any number of elements makes the same helix, of radius kappa / (kappa^2 + tau^2) about the axis Omega.
TEST(CarriedFrames, MakeOneHelix) {
  const double radius = kCurvature.head<2>().norm() / kCurvature.squaredNorm();
  std::vector<HelixElement> elements(10);
  for (int i = 0; i < 10; ++i) {
    elements[i].length = 0.4 + 0.3 * (i % 4);
    elements[i].curvature = kCurvature;
  }
  const MaterialFrame root = some_root();
  carry_frames(root, elements);
  const Vector3d omega = root.axes * kCurvature, axis = omega.normalized();
  const Vector3d centre = root.position + radius * omega.cross(Vector3d(root.axes.col(2))).normalized();
  for (const HelixElement& element : elements) {
    const Vector3d from = element.end.position - centre;
    EXPECT_NUMBER((from - from.dot(axis) * axis).norm(), radius, 1e-12)
        << "the distance from the helix' axis";
  }
}

// ---- (3)

TEST(Stiffness, IsEIAndGJTimesTheLength) {
  HelixStrand strand;
  strand.lengths = Eigen::Vector2d(0.5, 2);
  strand.bend_rigidity = 3;
  strand.twist_rigidity = 7;
  strand.natural = VectorXd::Zero(6);
  expect_numbers(stiffness_of(strand), vector({1.5, 1.5, 3.5, 6, 6, 14}), 1e-13,
                 "K of elements of 0.5 m and 2 m, EI = 3, GJ = 7");
}

TEST(Elasticity, VanishesAtTheNaturalShape) {
  const HelixStrand strand = strand_of(crooked_strand());
  EXPECT_EQ(elastic_of(strand, strand.natural).norm(), 0) << "of a strand that lies as it is by nature";
}

TEST(Elasticity, PullsBackWhereItIsBent) {
  const HelixStrand strand = strand_of(crooked_strand());
  const VectorXd bent = scattered_vector(12, 6);
  VectorXd expected(12);
  for (int i = 0; i < 4; ++i)
    expected.segment<3>(3 * i) =
        -strand.lengths[i] * Vector3d(3, 3, 1.5).cwiseProduct(Vector3d(bent.segment<3>(3 * i)));
  expect_numbers(elastic_of(strand, strand.natural + bent), expected, 1e-12,
                 "the force of four elements: -(EI, EI, GJ) l (q - q^n), EI = 3, GJ = 1.5");
}

// ---- (4)

TEST(NearlyStraight, OfAStraightElement) {
  const HelixJacobian J = hair::jacobian_at({}, Vector3d::Zero(), 0.5),
                      expected = straight(Matrix3d::Identity(), 0.5);
  expect_matrix(J.turns, expected.turns, 1e-13, "turns at 0.5 m: s n_k");
  expect_matrix(J.moves, expected.moves, 1e-13, "moves at 0.5 m: s^2/2 n_k x t");
}

namespace {

enum class Column { turns, moves };

void expect_derivative(Column part) {
  const MaterialFrame root = some_root();
  for (const double size : {0.0, 1e-6, 0.1, 1.0, 10.0, 30.0, 100.0}) {
    // Elements that wind more than twice may have frames that are off by 1e-10.
    const bool winds = size > 10;
    const double h = winds ? 1e-4 : 1e-5, bound = winds ? 1e-5 : 1e-9;
    const std::string source = winds ? "1e-5: errors of 1e-10 in each frame, over 1e-4 / m"
                                     : "1e-9: central differences over 1e-5 / m";
    const Vector3d curvature = size * kCurvature;
    const HelixJacobian J = hair::jacobian_at(root, curvature, 0.7);
    for (int k = 0; k < 3; ++k) {
      const Vector3d change = h * Vector3d::Unit(k);
      const MaterialFrame ahead = hair::frame_at(root, curvature + change, 0.7),
                          behind = hair::frame_at(root, curvature - change, 0.7);
      const std::string of =
          std::string(" for ") + kCoordinates[k] + ", |curvature| = " + number(curvature.norm());
      if (part == Column::moves) {
        expect_entries(J.moves.col(k), (ahead.position - behind.position) / (2 * h), bound,
                       "how the point moves" + of, source);
        continue;
      }
      const Matrix3d turn = ahead.axes * behind.axes.transpose();
      const Vector3d by(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
      expect_entries(J.turns.col(k), by / (4 * h), bound, "how the frame turns" + of, source);
    }
  }
}

}  // namespace

TEST(Jacobians, TurnsAsTheFrameDoes) {
  expect_derivative(Column::turns);
}

TEST(Jacobians, MovesAsThePointDoes) {
  expect_derivative(Column::moves);
}

// To bend a straight element a little further moves its end by s^2 / 2, whatever the unit of length.
TEST(OtherUnits, OfElementsOfAnyLength) {
  const HelixJacobian one = hair::jacobian_at({}, 0.3 * kCurvature, 1);
  for (const double scale : {0x1p-40, 0x1p40}) {
    const HelixJacobian J = hair::jacobian_at({}, 0.3 / scale * kCurvature, scale);
    expect_entries((J.turns / scale).reshaped(), one.turns.reshaped(), 1e-10,
                   "turns / s of an element of " + number(scale) + " m, compared with that of 1 m");
    expect_entries((J.moves / (scale * scale)).reshaped(), one.moves.reshaped(), 1e-10,
                   "moves / s^2 of an element of " + number(scale) + " m, compared with that of 1 m");
  }
}

// ---- (5)

TEST(Forces, OfAForceAtTheTip) {
  // The strand goes 2 m along z and is held at 0. 3 N along y at the tip bend element 0 about -x, with the
  // arm from each of its points.
  Lying lying = straight_strand(2, 2, 1);
  HelixPoint tip;
  tip.element = 1;
  tip.s = 1;
  tip.position = Vector3d(0, 0, 2);
  tip.moves = straight(Matrix3d::Identity(), 1).moves;
  tip.force = Vector3d(0, 3, 0);
  lying.points.push_back(tip);
  // Element 0 has arms of 2 to 1 m, 1.5 m on average over its length of 1 m; element 1 has 0.5 m on average.
  expect_numbers(force_of(lying), vector({-4.5, 0, 0, -1.5, 0, 0}), 1e-13,
                 "Q of 3 N across the tip of a straight strand: minus the integral of force times arm");
}

// Q^T q' = sum of force . velocity.
TEST(Forces, HasThePowerOfTheForces) {
  for (const std::set<int>& bare : {std::set<int>{}, {0}, {2}, {0, 1, 3}}) {
    Lying lying = crooked_strand();
    std::erase_if(lying.points, [&](const HelixPoint& point) { return bare.contains(point.element); });
    const VectorXd Q = force_of(lying);
    for (int k = 0; k < 12; ++k) {
      const std::vector<Vector3d> v = velocities(lying, VectorXd::Unit(12, k));
      double power = 0;
      for (std::size_t j = 0; j < v.size(); ++j) power += lying.points[j].force.dot(v[j]);
      EXPECT_NUMBER(Q[k], power, 1e-12)
          << "coordinate " << k % 3 << " of element " << k / 3
          << " of 4, where Q' q' is the power of all forces; " << bare.size() << " elements have no points";
    }
  }
}

// ---- (6)

namespace {

// u^T M w = sum of velocity(u) . inertia velocity(w). The blocks of M of one element, or of two.
void expect_kinetic_energy(bool of_one) {
  const Lying lying = crooked_strand();
  const MatrixXd M = mass_of(lying);
  for (int k = 0; k < 12; ++k)
    for (int m = 0; m < 12; ++m) {
      if ((k / 3 == m / 3) != of_one) continue;
      const std::vector<Vector3d> u = velocities(lying, VectorXd::Unit(12, k)),
                                  w = velocities(lying, VectorXd::Unit(12, m));
      double expected = 0;
      for (std::size_t j = 0; j < u.size(); ++j) expected += u[j].dot(lying.points[j].inertia * w[j]);
      EXPECT_NUMBER(M(k, m), expected, 1e-11)
          << "M(" << k << ", " << m << ") of a strand of 4 elements: elements " << k / 3 << " and " << m / 3;
    }
}

}  // namespace

TEST(Masses, OfAStraightElement) {
  const MatrixXd one = mass_of(straight_strand(1, 2, 5));
  EXPECT_NUMBER(one(0, 0), 5 * 32.0 / 20, 1e-12) << "rho S l^5 / 20, rho S = 5 kg/m, l = 2 m";
  EXPECT_NUMBER(one(0, 1), 0, 1e-12) << "bending about n1 moves nothing where bending about n2 does";
  EXPECT_NUMBER(one.col(2).norm() + one.row(2).norm(), 0, 1e-12) << "to twist straight hair moves nothing";
}

TEST(Masses, OfEachElementOnTheDiagonal) {
  const MatrixXd two = mass_of(straight_strand(2, 2, 5));
  EXPECT_NUMBER(two(3, 3), 5 / 20.0, 1e-12) << "element 1 alone, of a straight strand";
  EXPECT_NUMBER(two(0, 0), 5 * (1 / 20.0 + 13 / 12.0), 1e-12) << "element 0 carries element 1";
  expect_kinetic_energy(true);
}

TEST(Masses, OfTwoElements) {
  const MatrixXd two = mass_of(straight_strand(2, 2, 5));
  EXPECT_NUMBER(two(0, 3), 5 * 5 / 24.0, 1e-12) << "element 0 and element 1, of a straight strand";
  EXPECT_NUMBER(two(3, 0), 5 * 5 / 24.0, 1e-12) << "element 1 and element 0: M is symmetric";
  expect_kinetic_energy(false);
  const MatrixXd M = mass_of(crooked_strand());
  const double least = Eigen::LDLT<MatrixXd>(M).vectorD().minCoeff();
  EXPECT_GE(least, -1e-12 * M.norm()) << "the least pivot of M, which is positive semi-definite";
}

// Elements without points of their own carry the points further out.
TEST(BareElements, OfElementsWithoutPoints) {
  Lying light = crooked_strand(), bare = light;
  for (HelixPoint& point : light.points)
    if (point.element == 0 || point.element == 2) point.inertia.setZero();
  std::erase_if(bare.points,
                [](const HelixPoint& point) { return point.element == 0 || point.element == 2; });
  expect_entries(mass_of(bare).reshaped(), mass_of(light).reshaped(), 1e-11,
                 "M where elements 0 and 2 have no points, compared with M where their points have no mass");
}

// ---- (7)

TEST(StiffSteps, OfOneStraightElement) {
  Lying lying = straight_strand(1, 2, 5);
  for (HelixPoint& point : lying.points) point.force = point.inertia * Vector3d(0, 4, 0);  // weight along y
  HelixStrand strand = strand_of(lying);
  strand.natural = Vector3d(0.1, 0, 0.2);
  const double h = 0.5, M = 5 * 32.0 / 20, Q = -4 * 5 * 8.0 / 6;
  const Vector3d q(0.05, 0, -0.3), rates(0.3, 0, -1);
  // Each coordinate is alone: (M + h^2 K) change = h (Q - K (q + h q' - q^n)), K = (6, 6, 3).
  const Vector3d expected(h * (Q - 6 * (0.05 + h * 0.3 - 0.1)) / (M + h * h * 6), 0,
                          -h * 3 * (-0.3 + h * -1 - 0.2) / (h * h * 3));
  expect_entries(step_of(strand, lying, q, rates, h), expected, 1e-8,
                 "change of a straight element under its weight across, h = 0.5 s",
                 "1e-8: 1e-10, times the condition number");
}

TEST(StiffSteps, LeavesWhatIsAtRest) {
  const Lying lying = straight_strand(3, 2, 5);
  HelixStrand strand = strand_of(lying);
  strand.natural.setZero();
  expect_numbers(step_of(strand, lying, VectorXd::Zero(9), VectorXd::Zero(9), 0.1), VectorXd::Zero(9), 1e-300,
                 "change of straight hair at rest without forces", "0");
}

namespace {

// The residual, with your own M, K, Q and elastic force.
void expect_solved(std::initializer_list<double> masses) {
  for (const double small : masses) {
    Lying lying = crooked_strand();
    HelixStrand strand = strand_of(lying);
    strand.bend_rigidity *= small;
    strand.twist_rigidity *= small;
    for (HelixPoint& point : lying.points) {
      point.force *= small;
      point.inertia *= small;
    }
    const VectorXd q = scattered_vector(12, 8), rates = scattered_vector(12, 9);
    for (const double h : {0.001, 0.1}) {
      const VectorXd change = step_of(strand, lying, q, rates, h);
      MatrixXd matrix = mass_of(lying);
      matrix.diagonal() += h * h * stiffness_of(strand);
      const VectorXd right = h * (force_of(lying) + elastic_of(strand, q + h * rates));
      const VectorXd left = matrix * change - right;
      const double allowed = 1e-10 * (matrix.norm() * change.norm() + right.norm());
      int first = 0;
      while (first < 3 && left.segment<3>(3 * first).norm() <= allowed) ++first;
      EXPECT_LE(left.norm(), allowed)
          << "element " << first
          << " is the first one whose three equations are not solved; what (M + h^2 K) change = h (Q - K (q "
             "+ h q' - q^n)) leaves, h = "
          << h << ", masses of " << small
          << " kg; 1e-10 of the matrix times the change, and of the right side, are allowed";
    }
  }
}

}  // namespace

TEST(Steps, SolvesItsSystem) {
  expect_solved({1});
}

// M of hair is some 1e-17 kg m^4, so nothing may be too small for it.
TEST(OtherUnits, SolvesItsSystemHoweverLight) {
  expect_solved({1e-7, 1e-20});
}

int main(int argc, char** argv) {
  static std::vector<HelixElement> elements(1);
  static const std::vector<HelixPoint> points(1);
  static const HelixStrand strand{VectorXd::Ones(1), 1, 1, 1, VectorXd::Zero(3)};
  static const VectorXd zero = VectorXd::Zero(3);
  static VectorXd result = zero;
  static MatrixXd matrix = MatrixXd::Zero(3, 13);
  return run(argc, argv,
             {{"stumpff", [] { hair::stumpff(1); }},
              {"frame_at", [] { hair::frame_at({}, Vector3d::Ones(), 1); }, {"stumpff"}},
              {"carry_frames", [] { carry_frames({}, elements); }, {"frame_at"}},
              {"helix_stiffness", [] { helix_stiffness(strand, result); }},
              {"elastic_force", [] { elastic_force(strand, zero, result); }},
              {"jacobian_at", [] { hair::jacobian_at({}, Vector3d::Ones(), 1); }, {"frame_at"}},
              {"generalised_force", [] { generalised_force(elements, points, result); }},
              {"mass_matrix", [] { mass_matrix(elements, points, matrix.leftCols(3)); }},
              {"helix_step",
               [] { helix_step(strand, elements, points, zero, zero, 1, matrix, result); },
               {"mass_matrix", "generalised_force", "elastic_force", "helix_stiffness"}}});
}
