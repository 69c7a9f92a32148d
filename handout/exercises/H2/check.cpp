// The public checks of H2. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/angular_springs.h.

#include "hair/angular_springs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <span>

#include "check.h"
#include "derivative.h"
#include "ordinary.h"
#include "strands.h"

using namespace checks;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::Strand;
using std::numbers::pi;

namespace {

// EI = 4 N m^2
Strand strand_of(const VectorXd& rest_length) {
  return strand_with(&Strand::bend_rigidity, 4, rest_length);
}

// Segments of 1 m with rest lengths of 1 m: k = EI = 4 N m. The first one points down; each next one is
// turned by `bend`, in planes that turn.
Case bent(int count, double bend) {
  Case result{strand_of(VectorXd::Ones(count - 1)), VectorXd::Zero(3 * count)};
  Vector3d direction(0, 0, -1), axis(1, 0, 0);
  for (int i = 0; i + 1 < count; ++i) {
    result.x.segment<3>(3 * i + 3) = result.x.segment<3>(3 * i) + direction;
    direction = (Eigen::AngleAxisd(bend, axis) * direction).normalized();
    axis = (Eigen::AngleAxisd(0.8 * i, direction) * axis.cross(direction).cross(direction)).normalized();
  }
  return result;
}

// Lengths and rest lengths between 0.5 and 1.5 m, bent every way by up to 2 radians or so.
Case uneven(int count, int which) {
  const VectorXd numbers = scattered_vector(5 * count, which);
  Case result{strand_of(VectorXd::Ones(count - 1) + numbers.head(count - 1) / 2), VectorXd::Zero(3 * count)};
  for (int i = 0; i + 1 < count; ++i) {
    const Vector3d direction = (Vector3d(0, 0, -0.5) + numbers.segment<3>(count + 3 * i)).normalized();
    result.x.segment<3>(3 * i + 3) =
        result.x.segment<3>(3 * i) + (1 + numbers[4 * count + i] / 2) * direction;
  }
  return result;
}

Case clamped(Case c) {
  c.strand.clamped = true;
  c.strand.root_tangent = Vector3d(0, 0.6, -0.8);
  return c;
}

VectorXd force(const Strand& strand, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  add_bend_force(strand, x, f);
  return f;
}

VectorXd product(const Strand& strand, const VectorXd& x, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  add_bend_product(strand, x, dx, df);
  return df;
}

VectorXd product_spd(const Strand& strand, const VectorXd& x, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  add_bend_product_spd(strand, x, dx, df);
  return df;
}

// The answer of one of the exercise's functions.
struct Answer {
  const char* name;
  int power;  // the answer has the unit of length to this power
  double bound;
  const char* source_of_bound;
  VectorXd (*of)(const Strand&, const VectorXd& x, const VectorXd& dx);
};
const Answer kAnswers[] = {
    {"the energy", -1, 256 * kU * 200, "256 u of k pi^2 / 2 of each joint: rounding",
     [](const Strand& strand, const VectorXd& x, const VectorXd&) {
       return vector({bend_energy(strand, x)});
     }},
    {"the force", -2, 256 * kU * 16 * pi, "256 u of k pi / |e|: rounding",
     [](const Strand& strand, const VectorXd& x, const VectorXd&) { return force(strand, x); }},
    {"the product", -3, 1024 * kU * 200, "1024 u of k pi / |e|^2: rounding", product},
    {"the semi-definite product", -3, 1024 * kU * 200, "1024 u of k pi / |e|^2: rounding", product_spd}};

void expect_no_force(const Strand& strand, const VectorXd& x, const std::string& where) {
  const VectorXd dx = scattered_vector(static_cast<int>(x.size()), 1);
  for (const Answer& answer : std::span(kAnswers).subspan(1)) {
    const VectorXd actual = answer.of(strand, x, dx);
    EXPECT_EQ(actual, VectorXd::Zero(x.size()))
        << answer.name << " " << where << ", x = " << particles_in_words(x)
        << "; actual: " << particles_in_words(actual);
  }
}

// A straight strand, but for a right angle at this joint.
VectorXd with_corner(int segments, int joint) {
  VectorXd x = VectorXd::Zero(3 * segments + 3);
  for (int i = 0; i < segments; ++i)
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + (i < joint ? Vector3d(0, 0, -1) : Vector3d(0, 1, 0));
  return x;
}

const VectorXd kRestLengths = vector({0.5, 2.5, 0.7, 1.9});
double mean_at(int joint) {
  return (kRestLengths[joint - 1] + kRestLengths[joint]) / 2;
}

const VectorXd kRightAngle = with_corner(2, 1);
const VectorXd kBentByLess = vector({0, 0, 0, 0, 0, -1, 0, std::sin(0.8), -1 - std::cos(0.8)});
const VectorXd kFold = vector({0, 0, 0, 0, 0, -1, 0, 0, 0});

// A clamped strand whose only segment has no length.
const Case kLone = clamped({strand_of(vector({1})), vector({1, 2, 3, 1, 2, 3})});

}  // namespace

TEST(Energy, OfOneJoint) {
  const Strand strand = strand_of(vector({1, 1}));
  SCOPED_TRACE(
      "a strand that is not clamped, EI = 4 N m^2, rest lengths 1 m and 1 m: k = 4 N m, E = 4 * phi^2 / 2 J");
  EXPECT_NUMBER(bend_energy(strand, kBentByLess), 2 * 0.64, 64 * kU * 4) << "phi = 0.8; bound: rounding";
  EXPECT_NUMBER(bend_energy(strand, kRightAngle), 2 * pi * pi / 4, 32 * kU * 4)
      << "phi = pi/2; bound: rounding";
  EXPECT_NUMBER(bend_energy(strand, vector({0, 0, 0, 0, 0, -1, 0, 0, -2})), 0, 0) << "straight";
  EXPECT_NUMBER(bend_energy(strand, kFold), 2 * pi * pi, 32 * kU * 4) << "folded, phi = pi; bound: rounding";
}

TEST(Sampling, TakesTheMeanOfTwoRestLengths) {
  for (const int joint : {1, 2, 3})
    EXPECT_NUMBER(bend_energy(strand_of(kRestLengths), with_corner(4, joint)),
                  4 / mean_at(joint) * pi * pi / 8, 32 * kU * 4)
        << "EI = 4 N m^2, rest lengths " << in_words({kRestLengths.begin(), kRestLengths.end()})
        << " m, whatever the lengths are now; straight, but for phi = pi/2 at joint " << joint
        << ", whose k is 4 / " << mean_at(joint) << " N m";
}

TEST(Sampling, OfTheLecturesCircleDoesNotDependOnTheSampling) {
  const double R = 0.3;
  for (int n : {8, 16, 32}) {
    const double l = 2 * pi * R / n;
    const Strand strand = strand_of(VectorXd::Constant(n, l));
    VectorXd x = VectorXd::Zero(3 * n + 3);
    for (int i = 0; i < n; ++i)
      x.segment<3>(3 * i + 3) =
          x.segment<3>(3 * i) + l * Vector3d(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
    // The last segment does not meet the first one: n - 1 joints.
    EXPECT_NUMBER(bend_energy(strand, x) * n / (n - 1), pi * 4 / R, 1e-10)
        << "a circle of radius 0.3 m in " << n
        << " segments, EI = 4 N m^2: pi EI / R; bound: rounding, 64 u n^2 of it";
  }
}

TEST(NearlyStraight, OfSmallAnglesKeepsItsDigits) {
  for (double phi : {1e-3, 1e-5, 1e-7}) {
    // tan(phi) is phi to third order, and this strand turns by exactly atan(phi).
    const double E = bend_energy(strand_of(vector({1, 1})), vector({0, 0, 0, 0, 0, -1, 0, phi, -2}));
    const double expected = 2 * std::atan(phi) * std::atan(phi);
    EXPECT_NUMBER(E, expected, 128 * kU * phi)
        << "phi = atan(" << phi
        << "), k = 4 N m; bound: phi known to a few u. Does your angle come from acos?";
  }
}

TEST(ClampedRoot, OfAClampedRoot) {
  const Case c = clamped({strand_of(vector({0.5, 2.5})), vector({0, 0, 0, 0, 0.8, 0.6, 0, 1.6, 1.2})});
  EXPECT_NUMBER(bend_energy(c.strand, c.x), 16 * pi * pi / 8, 32 * kU * 16)
      << "straight, at a right angle to root_tangent, the first rest length 0.5 m: k = 2 EI / l = 16 N m; "
         "bound: rounding";
}

TEST(NoDirection, WithoutAJointIsZero) {
  EXPECT_NUMBER(bend_energy(strand_of(vector({1})), vector({1, 2, 3, 3, 3, 3})), 0, 0)
      << "two particles, free";
  EXPECT_NUMBER(bend_energy(strand_of(VectorXd(0)), vector({1, 2, 3})), 0, 0) << "one particle";
  EXPECT_NUMBER(bend_energy(clamped({strand_of(VectorXd(0)), {}}).strand, vector({1, 2, 3})), 0, 0)
      << "one particle, clamped: no segment begins there";
  EXPECT_NUMBER(bend_energy(kLone.strand, kLone.x), 0, 0) << "clamped, and its only segment has the length 0";
  EXPECT_NUMBER(bend_energy(strand_of(vector({1, 1})), vector({0, 0, 0, 0, 1, 0, 0, 1, 0})), 0, 0)
      << "a segment of length 0";
  EXPECT_NUMBER(bend_energy(strand_of(vector({1, 1})), vector({0, 0, 0, -1, -2, -2, -1, -2, -2})), 0, 0)
      << "a segment of length 0 behind one along (-1, -2, -2): their dot product is -0, and atan2(0, -0) is "
         "pi";
}

TEST(Forces, OfOneJoint) {
  // k phi / |e| = 2 pi, at right angles to each segment, against the bend.
  expect_entries(force(strand_of(vector({1, 1})), kRightAngle),
                 2 * pi * vector({0, 1, 0, 0, -1, -1, 0, 0, 1}) * -1, 64 * kU * 4 * pi,
                 "the force of one joint, k = 4 N m, at x = " + particles_in_words(kRightAngle),
                 "64 u of k phi / |e|: rounding");
}

TEST(Forces, IsMinusTheEnergysGradient) {
  for (double bend : {1e-6, 0.3, 1.5, 2.8}) {
    const Case c = bent(6, bend);
    SCOPED_TRACE("each joint bent by " + std::to_string(bend));
    // Next to the fold all changes within pi - phi.
    expect_force(
        force(c.strand, c.x), [&](const VectorXd& x) { return bend_energy(c.strand, x); }, c.x,
        std::min(1.0, pi - bend), 4 * pi);
  }
}

TEST(CurrentLengths, IsMinusTheEnergysGradientAtUnevenLengths) {
  const Case c = uneven(7, 1);
  expect_force(
      force(c.strand, c.x), [&](const VectorXd& x) { return bend_energy(c.strand, x); }, c.x, 0.1, 16 * pi);
}

TEST(ClampedRoot, IsMinusTheEnergysGradientWithAClampedRoot) {
  for (const Case& c : {clamped(uneven(2, 2)), clamped(uneven(5, 3))})
    expect_force(
        force(c.strand, c.x), [&](const VectorXd& x) { return bend_energy(c.strand, x); }, c.x, 0.1, 16 * pi);
}

TEST(Sampling, TakesTheMeanOfTwoRestLengthsByAddBendForce) {
  for (const int joint : {1, 2, 3})
    expect_entries(force(strand_of(kRestLengths), with_corner(4, joint)) * mean_at(joint),
                   force(strand_of(VectorXd::Ones(4)), with_corner(4, joint)), 64 * kU * 4 * pi,
                   "the force of a right angle between rest lengths whose mean is " +
                       std::to_string(mean_at(joint)) +
                       " m, times that, compared with the force with rest lengths of 1 m",
                   "64 u of k phi / |e|: rounding");
}

TEST(Forces, GivesNoNetForceOrTorque) {
  const Case c = uneven(9, 4);
  const VectorXd f = force(c.strand, c.x);
  EXPECT_GT(f.norm(), 1) << "no force at all";
  expect_balanced(f, c.x, 9 * 256 * kU * 16 * pi, "rounding: 256 u of k pi / |e| for each of 9 particles");
}

TEST(Added, IsAddedToWhatFHolds) {
  const Case c = uneven(5, 1);
  expect_added([&](VectorXd& f) { add_bend_force(c.strand, c.x, f); }, scattered_vector(15, 8), 16 * kU * 100,
               "f");
}

TEST(Extremes, IsTheSameHoweverOftenItIsAsked) {
  const Case c = clamped(uneven(5, 1));
  const VectorXd first = force(c.strand, c.x);
  for (int i = 1; i <= kManyCalls; ++i)
    ASSERT_EQ(force(c.strand, c.x), first) << "asked again for the same strand, " << i << " times so far";
}

TEST(Extremes, OfALongStrand) {
  // A zigzag of right angles: each joint has k = 4 N m, and 2 pi N at its ends.
  const int n = 10001;
  const Strand strand = strand_of(VectorXd::Ones(n - 1));
  VectorXd x = VectorXd::Zero(3 * n);
  for (int i = 1; i < n; ++i) x.segment<3>(3 * i) = x.segment<3>(3 * i - 3) + Vector3d::Unit(1 + i % 2);
  const VectorXd f = force(strand, x);
  const std::string source = "64 u of k phi / |e|: rounding";
  expect_entries(f.head<3>(), Vector3d(0, -2 * pi, 0), 64 * kU * 4 * pi,
                 "the force on the root of a zigzag of 10,001 particles", source);
  expect_entries(f.tail<3>(), Vector3d(0, 0, 2 * pi), 64 * kU * 4 * pi, "the force on the tip of the same",
                 source);
}

// The force does not become 0 before the fold is reached: k (pi - missing) / |e|, across the segment.
TEST(Fold, NextToTheFold) {
  const Strand strand = strand_of(vector({1, 1}));
  for (const double missing : {1e-3, 1e-5}) {
    const double tip =
        force(strand, vector({0, 0, 0, 0, 0, -1, 0, std::sin(missing), -1 + std::cos(missing)}))
            .tail<3>()
            .norm();
    EXPECT_NUMBER(tip, 4 * (pi - missing), 64 * kU * 4 * pi / missing)
        << "the size of the force on the tip, bent by pi - " << missing
        << ", k = 4 N m: k (pi - missing) / |e|; bound: rounding of the sine, 64 u over " << missing;
  }
}

TEST(NearlyStraight, OfASmallAngleHasAForce) {
  for (const double phi : {1e-3, 1e-5, 1e-7}) {
    const VectorXd x = vector({0, 0, 0, 0, 0, -1, 0, phi, -2});
    EXPECT_NUMBER(force(strand_of(vector({1, 1})), x).tail<3>().norm(),
                  4 * std::atan(phi) / std::sqrt(1 + phi * phi), 256 * kU * 4)
        << "the size of the force on the tip, phi = atan(" << phi
        << "), k = 4 N m: k phi / |e|; bound: rounding";
  }
}

TEST(NearlyStraight, OfAStraightStrandIsZero) {
  EXPECT_EQ(force(strand_of(vector({1, 1})), vector({0, 0, 0, 0, 0, -1, 0, 0, -2})), VectorXd::Zero(9));
}

TEST(ExactProduct, IsTheForcesDerivative) {
  for (double bend : {1e-6, 0.3, 1.5, 2.8}) {
    const Case c = bent(6, bend);
    const VectorXd dx = scattered_vector(18, 5);
    SCOPED_TRACE("each joint bent by " + std::to_string(bend));
    expect_product(
        product(c.strand, c.x, dx), [&](const VectorXd& x) { return force(c.strand, x); }, c.x, dx,
        std::min(1.0, pi - bend), 4 * pi / std::min(1.0, pi - bend));
  }
}

TEST(CurrentLengths, IsTheForcesDerivativeAtUnevenLengths) {
  const Case c = uneven(7, 1);
  const VectorXd dx = scattered_vector(21, 6);
  expect_product(
      product(c.strand, c.x, dx), [&](const VectorXd& x) { return force(c.strand, x); }, c.x, dx, 0.1, 200);
}

TEST(ClampedRoot, IsTheForcesDerivativeWithAClampedRoot) {
  for (const Case& c : {clamped(uneven(2, 2)), clamped(uneven(5, 3))}) {
    const VectorXd dx = scattered_vector(static_cast<int>(c.x.size()), 6);
    expect_product(
        product(c.strand, c.x, dx), [&](const VectorXd& x) { return force(c.strand, x); }, c.x, dx, 0.1, 200);
  }
}

TEST(ExactProduct, IsSymmetric) {
  const Case c = clamped(uneven(8, 2));
  expect_symmetric([&](const VectorXd& dx) { return product(c.strand, c.x, dx); }, scattered_vector(24, 1),
                   scattered_vector(24, 2), 24 * 1024 * kU * 200,
                   "24 entries, 1024 u of k pi / |e|^2 each: rounding");
}

// The energy is k/2 |P (de_1 / |e_1| - de_0 / |e_0|)|^2, where P takes away what lies along the strand.
void expect_straight_product(const Vector3d& root, const Vector3d& u, double a, double b, double relative,
                             const std::string& source_of_bound) {
  VectorXd x(9), expected(9);
  x << root, root + a * u, root + (a + b) * u;
  const VectorXd dx = scattered_vector(9, 4);
  const Vector3d turn = (dx.tail<3>() - dx.segment<3>(3)) / b - (dx.segment<3>(3) - dx.head<3>()) / a,
                 across = 4 * (turn - u * u.dot(turn) / u.squaredNorm()) / u.squaredNorm();
  expected << -across / a, across / a + across / b, -across / b;
  expect_entries(product(strand_of(vector({1, 1})), x, dx), expected,
                 relative * 4 / (std::min(a, b) * std::min(a, b) * u.squaredNorm()),
                 "the exact product of a straight strand, x = " + particles_in_words(x) +
                     ", k = 4 N m, dx = " + particles_in_words(dx),
                 source_of_bound);
}

TEST(StraightProducts, OfAStraightStrand) {
  // Their segments are equal to the last bit, and some have unit vectors with a square below 1.
  for (const Vector3d& e : {Vector3d(0, 0, -1), Vector3d(0, 0, -0.125), Vector3d(0.25, 0.75, -0.75),
                            Vector3d(0, 0.5, 0.5), Vector3d(-0.75, 1, 0.75)})
    expect_straight_product(Vector3d::Zero(), e, 1, 1, 1024 * kU, "1024 u of k / |e|^2: rounding");
}

TEST(StraightProducts, OfABendThatIsRounding) {
  Scatter numbers(1);
  for (int which = 0; which < 12; ++which) {
    const Vector3d root = ordinary_direction(numbers), u = ordinary_direction(numbers);
    const double a = ordinary_number(numbers, 0.3, 2.3), b = ordinary_number(numbers, 0.3, 2.3, a);
    expect_straight_product(
        root, u, a, b, 1e-5,
        "1e-5 of k / |e|^2. A bend that is nothing but rounding has the limits of a straight joint");
  }
}

TEST(ExactProduct, IsIndefinite) {
  // phi = pi/2, k = 4, |e| = 1: if the ends leave the bend's plane, one to either side, the second derivative
  // is -k phi tan(phi/2) = -2 pi.
  const Strand strand = strand_of(vector({1, 1}));
  const VectorXd out = vector({1, 0, 0, 0, 0, 0, -1, 0, 0}), df = product(strand, kRightAngle, out);
  EXPECT_NUMBER(out.dot(df) / 2, 2 * pi, 64 * kU * 4 * pi)
      << "out . (df/dx) out / |out|^2 for a right angle, k = 4 N m, out = " << particles_in_words(out)
      << ": the energy falls along it, by k phi tan(phi/2) = 2 pi; (df/dx) out = " << particles_in_words(df);
}

TEST(SpdProduct, IsTheFormula) {
  const Strand strand = strand_of(vector({1, 1}));
  // phi = pi/2: cot(phi) = 0, and only the bend itself counts: k grad phi grad phi^T.
  const VectorXd gradient = vector({0, 1, 0, 0, -1, -1, 0, 0, 1});
  for (const VectorXd& dx : {gradient, scattered_vector(9, 3)})
    expect_entries(product_spd(strand, kRightAngle, dx), -4 * gradient * gradient.dot(dx), 256 * kU * 4 * 9,
                   "-k grad phi (grad phi . dx) at a right angle, k = 4 N m, dx = " + particles_in_words(dx),
                   "256 u of k / |e|^2: rounding");
  // phi = 1: out of the plane the bend resists with phi cot(phi) = 0.642.
  const VectorXd x = vector({0, 0, 0, 0, 0, -1, 0, std::sin(1), -1 - std::cos(1)}),
                 out = vector({1, 0, 0, 0, 0, 0, 1, 0, 0});
  const double turn = -4 / std::tan(1) * 2;  // g . out = 2 b . (1, 0, 0), over two entries
  expect_entries(product_spd(strand, x, out), vector({turn, 0, 0, -2 * turn, 0, 0, turn, 0, 0}),
                 256 * kU * 4 * 9,
                 "-k phi cot(phi) g (g . dx) at phi = 1, k = 4 N m, dx = " + particles_in_words(out),
                 "256 u of k / |e|^2: rounding");
}

TEST(SpdProduct, IsNegativeSemidefinite) {
  for (const Case& c : {bent(6, 0.3), bent(6, 2.8), clamped(uneven(7, 2))}) {
    for (int which = 0; which < 20; ++which) {
      const VectorXd dx = scattered_vector(static_cast<int>(c.x.size()), which);
      EXPECT_LE(dx.dot(product_spd(c.strand, c.x, dx)), 24 * 1024 * kU * 200)
          << "dx . df at x = " << particles_in_words(c.x) << ", dx = " << particles_in_words(dx)
          << "; df is -S dx with S semi-definite; bound: rounding";
    }
  }
}

TEST(CurrentLengths, IsSymmetricAtUnevenLengths) {
  const Case c = uneven(8, 2);
  expect_symmetric([&](const VectorXd& dx) { return product_spd(c.strand, c.x, dx); },
                   scattered_vector(24, 1), scattered_vector(24, 2), 24 * 1024 * kU * 200,
                   "24 entries, 1024 u of k pi / |e|^2 each: rounding");
}

TEST(ClampedRoot, HasTheJointOfAClampedRoot) {
  // One segment of 1 m, rest length 1 m, at a right angle to root_tangent: k = 2 EI / l = 8 N m, phi = pi/2,
  // and dphi/dx_1 = -root_tangent = (-0.6, 0, 0.8), for the tip moves against it where the bend grows. The
  // plane of the bend is askew.
  Strand strand = strand_of(vector({1}));
  strand.clamped = true;
  strand.root_tangent = Vector3d(0.6, 0, -0.8);
  const VectorXd x = vector({0, 0, 0, 0.64, 0.6, 0.48}), gradient = vector({0.6, 0, -0.8, -0.6, 0, 0.8});
  for (const VectorXd& dx : {gradient, scattered_vector(6, 5)})
    expect_entries(
        product_spd(strand, x, dx), -8 * gradient * gradient.dot(dx), 256 * kU * 8 * 9,
        "-k grad phi (grad phi . dx), a root clamped along (0.6, 0, -0.8) and its first segment at a right "
        "angle, k = 2 EI / l = 8 N m, dx = " +
            particles_in_words(dx),
        "256 u of k / |e|^2: rounding");
}

TEST(StraightProducts, IsExactForAStraightStrand) {
  Case c = bent(6, 0);
  const VectorXd dx = scattered_vector(18, 4);
  for (const Vector3d& direction :
       {Vector3d(0, 0, -1), Vector3d(0.36, 0.48, -0.8), Vector3d(0.3, -0.5, -0.7)}) {
    for (int i = 0; i < 6; ++i) c.x.segment<3>(3 * i) = 0.1 * i * direction;
    expect_entries(product_spd(c.strand, c.x, dx), product(c.strand, c.x, dx), 1e-4 * 4 * 100,
                   "the semi-definite product of a strand along " + particles_in_words(direction) +
                       ", compared with your exact one; dx = " + particles_in_words(dx),
                   "1e-4 of k / |e|^2. A bend that is nothing but rounding has no axis: choose one");
  }
}

TEST(Added, IsAddedToWhatDfHolds) {
  const Case c = uneven(5, 6);
  const VectorXd dx = scattered_vector(15, 2), before = scattered_vector(15, 9);
  expect_added([&](VectorXd& df) { add_bend_product(c.strand, c.x, dx, df); }, before, 64 * kU * 200, "df");
  expect_added([&](VectorXd& df) { add_bend_product_spd(c.strand, c.x, dx, df); }, before, 64 * kU * 200,
               "df (semi-definite)");
}

TEST(Fold, AtTheFoldIsZero) {
  for (const Vector3d& along :
       {Vector3d(0, 0, -1), Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0, 0, 1)}) {
    VectorXd x = VectorXd::Zero(9);
    x.segment<3>(3) = along;
    expect_no_force(strand_of(vector({1, 1})), x, "at the fold");
    Strand back = strand_of(vector({1}));
    back.clamped = true;
    back.root_tangent = -along;
    expect_no_force(back, x.head<6>(), "of a clamped root that is folded back");
  }
}

// A segment of length 0 has no joints, so the hair in front of it and the hair behind it are two strands.
TEST(NoDirection, BesideASegmentOfLengthZero) {
  Case whole = clamped(uneven(7, 5));
  whole.strand.rest_length.setOnes();
  whole.x.segment<3>(12) = Vector3d(whole.x.segment<3>(9));
  Case front{whole.strand, whole.x.head(12)}, behind{whole.strand, whole.x.tail(9)};
  front.strand.mass = whole.strand.mass.head(4);
  front.strand.rest_length = whole.strand.rest_length.head(3);
  behind.strand.mass = whole.strand.mass.tail(3);
  behind.strand.rest_length = whole.strand.rest_length.tail(2);
  behind.strand.clamped = false;
  const VectorXd dx = scattered_vector(21, 7);
  for (const Answer& answer : std::span(kAnswers).subspan(1)) {
    VectorXd expected(21);
    expected << answer.of(front.strand, front.x, dx.head(12)), answer.of(behind.strand, behind.x, dx.tail(9));
    expect_entries(
        answer.of(whole.strand, whole.x, dx), expected, 512 * kU * 200,
        std::string(answer.name) +
            " of 7 particles, where particles 3 and 4 are in the same place, compared with those of "
            "particles 0 to 3 and of particles 4 to 6 as strands of their own",
        "512 u of k pi / |e|^2: rounding");
  }
}

TEST(NoDirection, WhereDirectionsAreLostIsZero) {
  expect_no_force(kLone.strand, kLone.x, "of a clamped strand whose only segment has the length 0");
  for (const VectorXd& x : {vector({0, 0, 0, 0, 0, 0, 0, 1, 0}), vector({0, 0, 0, 0, 1, 0, 0, 1, 0}),
                            vector({1, 1, 1, 1, 1, 1, 1, 1, 1})})
    expect_no_force(strand_of(vector({1, 1})), x, "beside a segment of length 0");
}

// EI = 4 N m^2 is a steel wire's. A hair's is 2^-30 of it, and so are the energies and forces of its joints.
TEST(Extremes, OfAHairAsOfAWire) {
  for (const Case& c : {uneven(7, 1), clamped(uneven(5, 3))}) {
    Strand hair = c.strand;
    hair.bend_rigidity = std::ldexp(c.strand.bend_rigidity, -30);
    const VectorXd dx = scattered_vector(static_cast<int>(c.x.size()), 6);
    for (const Answer& answer : kAnswers)
      expect_entries(answer.of(hair, c.x, dx) * 0x1p30, answer.of(c.strand, c.x, dx), answer.bound,
                     "2^30 times " + std::string(answer.name) +
                         " for EI = 3.7e-9 N m^2, compared with that for EI = 4 N m^2",
                     answer.source_of_bound);
  }
}

// A clamped strand, down to the contract's 1e-100 m.
TEST(Extremes, InAnyUnit) {
  const VectorXd dx = scattered_vector(18, 7);
  for (const Answer& answer : kAnswers)
    expect_in_units([&](const Strand& strand, const VectorXd& x) { return answer.of(strand, x, dx); },
                    clamped(uneven(6, 4)), {-310, -45, 310}, answer.power, 1e-10, answer.name);
}

int main(int argc, char** argv) {
  static const Strand lone = strand_of(VectorXd(0));
  static const VectorXd x = VectorXd::Zero(3);
  static VectorXd out = x;
  return run(argc, argv,
             {{"bend_energy", [] { bend_energy(lone, x); }},
              {"add_bend_force", [] { add_bend_force(lone, x, out); }, {"bend_energy"}},
              {"add_bend_product", [] { add_bend_product(lone, x, x, out); }, {"add_bend_force"}},
              {"add_bend_product_spd",
               [] { add_bend_product_spd(lone, x, x, out); },
               {"add_bend_force", "add_bend_product"}}});
}
