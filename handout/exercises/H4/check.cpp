// The public checks of H4. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in particles/implicit_euler.h. The checks of solve_plain and implicit_euler need S1.

#include "particles/implicit_euler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "check.h"
#include "derivative.h"
#include "implicit_systems.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using hair::GeometricTerm;
using particles::Particles;
using particles::solve_plain;
using particles::SolveReport;
using particles::State;

namespace {

const double kU = std::ldexp(1.0, -53);

// Two particles of 2 and 3 kg, 2 m apart along x, and a spring of 4 N/m between them that is 1 m long at
// rest.
const Particles kFree{Eigen::Vector2d(2, 3), {0, 0}}, kPinned{Eigen::Vector2d(2, 3), {1, 0}},
    kOtherPinned{Eigen::Vector2d(2, 3), {0, 1}};

State apart() {
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[3] = 2;
  state.v << 0.5, 0, 0, -0.25, 1, 0;
  return state;
}

const char* const kText =
    "2 and 3 kg at (0, 0, 0) and (2, 0, 0), a spring of 4 N/m that is 1 m long at rest, drag of 0.5 N s/m";

std::string pinned_text(const Particles& particles) {
  if (particles.is_pinned(0)) return ", particle 0 pinned";
  return particles.is_pinned(1) ? ", particle 1 pinned" : ", both free";
}

VectorXd unit(int i) {
  return VectorXd::Unit(6, i);
}

VectorXd six(double a, double b, double c, double d, double e, double f) {
  VectorXd values(6);
  values << a, b, c, d, e, f;
  return values;
}

constexpr double kA = 0.55, kB = 0.35;

// Three particles in ThickAir.
struct Air {
  Particles particles;
  State state;
  std::string text;

  Air() {
    Scatter scatter(1);
    particles = ordinary_particles(scatter, 3);
    state = ordinary_state(scatter, 3);
    text = "for f = -x^2 v^3, entry by entry, a = 0.55, b = 0.35, masses " +
           in_words({particles.mass.begin(), particles.mass.end()}) +
           " kg, at x = " + particles_in_words(state.x) + ", v = " + particles_in_words(state.v);
  }
};

// A matrix with the eigenvalues 1, 2, ... times `unit`, reflected along (1, 2, 3, ...), so that no number of
// a product is 0.
Table counted_table(int size, double unit) {
  VectorXd w = VectorXd::LinSpaced(size, 1, size).normalized(),
           eigenvalues = VectorXd::LinSpaced(size, 1, size);
  const MatrixXd H = MatrixXd::Identity(size, size) - 2 * w * w.transpose();
  return Table(unit * (H * eigenvalues.asDiagonal() * H));
}

std::string table_text(int size, double unit, double rhs) {
  return std::to_string(size) + " unknowns, eigenvalues 1, 2, ... times " + ::testing::PrintToString(unit) +
         ", a right-hand side of length " + ::testing::PrintToString(rhs);
}

}  // namespace

TEST(Masses, IsTheMassesWhereNothingActs) {
  const Spring none(0, 1, GeometricTerm::full);
  expect_entries(times(*implicit_matrix(none, kFree, apart(), 0.1, 0.1), six(1, 2, 3, 4, 5, 6)),
                 six(2, 4, 6, 12, 15, 18), 0, "the product of M with (1, 2, 3, 4, 5, 6), masses 2 and 3 kg",
                 "small integers don't round", six(1, 2, 3, 4, 5, 6));
}

TEST(Matrix, SubtractsBothDerivatives) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  auto matrix = implicit_matrix(spring, kFree, state, 0.5, 0.25);
  const std::string what = std::string("the product of the matrix, a = 0.5, b = 0.25, for ") + kText;
  // df/dx is -4 along the spring, and -4 (1 - 1/2) across it; df/dv is -0.5.
  expect_entries(times(*matrix, unit(3)), six(-0.5, 0, 0, 3 + 0.25 + 0.5, 0, 0), 32 * kU,
                 what + ", with the x of particle 1", "32 u: rounding");
  expect_entries(times(*matrix, unit(1)), six(0, 2 + 0.25 + 0.25, 0, 0, -0.25, 0), 32 * kU,
                 what + ", with the y of particle 0", "32 u: rounding");
}

TEST(Damping, SubtractsDamping) {
  const Spring drag(0, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  expect_entries(
      times(*implicit_matrix(drag, kFree, state, 0.5, 0.25), six(1, 2, 3, 4, 5, 6)),
      six(2.25, 4.5, 6.75, 13, 16.25, 19.5), 32 * kU,
      "the product with (1, 2, 3, 4, 5, 6), masses 2 and 3 kg, drag of 0.5 N s/m, a = 0.5, b = 0.25",
      "32 u: rounding");
}

TEST(Pinned, HasPinnedRowsAndColumnsOfTheIdentity) {
  Chain chain(2, 5);
  const particles::DampedSprings springs(chain.springs);
  Scatter scatter(1);
  chain.particles = ordinary_particles(scatter, 5);
  const VectorXd dx = ordinary_numbers(scatter, 15, -2, 2);
  const auto multiplied = [&](const VectorXd& x) {
    return times(*implicit_matrix(springs, chain.particles, chain.state, 0.5, 0.25), x);
  };
  VectorXd still = dx;
  for (const int i : {1, 4}) still.segment<3>(3 * i).setZero();
  VectorXd expected = multiplied(still);
  for (const int i : {1, 4}) {
    chain.particles.pinned[i] = 1;
    expected.segment<3>(3 * i) = dx.segment<3>(3 * i);
  }
  expect_entries(
      multiplied(dx), expected, 64 * kU * 9,
      "the product for five particles in a row on springs, 1 and 4 pinned, compared with that for free ones "
      "with 0 in their place; x = " +
          particles_in_words(dx),
      "64 u of numbers up to 9: rounding", dx);
}

TEST(Matrix, IsSymmetric) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  for (const Particles& particles : {kFree, kPinned, kOtherPinned}) {
    const MatrixXd A = table(spring, particles, apart(), 0.5, 0.25);
    EXPECT_LE((A - A.transpose()).cwiseAbs().maxCoeff(), 32 * kU)
        << "A =\n"
        << A << "\nfor " << kText << pinned_text(particles) << "; bound: 32 u, rounding";
  }
}

TEST(Cost, TakesOneProductOfEachKind) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  auto matrix = implicit_matrix(spring, kFree, state, 0.5, 0.25);
  times(*matrix, unit(0));
  const char* const allowed = "one; or 3n = 6 at first, for a matrix that is written out as a table";
  EXPECT_TRUE(spring.products_x == 1 || spring.products_x == 6)
      << spring.products_x << " products with df/dx for the first of the matrix; " << allowed;
  EXPECT_TRUE(spring.products_v == 1 || spring.products_v == 6)
      << spring.products_v << " products with df/dv for the first of the matrix; " << allowed;
}

TEST(Matrix, TakesDerivativesAtTheState) {
  const Air air;
  Scatter scatter(2);
  const VectorXd dx = ordinary_numbers(scatter, 9, -2, 2);
  const Eigen::ArrayXd x = air.state.x, v = air.state.v,
                       masses = air.particles.mass.transpose().replicate(3, 1).reshaped();
  const VectorXd expected =
      (masses + kA * 3 * x.square() * v.square() + kA * kB * 2 * x * v.cube()) * dx.array();
  expect_entries(times(*implicit_matrix(ThickAir(), air.particles, air.state, kA, kB), dx), expected, 1e-12,
                 "the product with " + particles_in_words(dx) + ", " + air.text);
}

TEST(Units, IsTheSameInEveryUnitByImplicitMatrix) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  auto matrix = implicit_matrix(spring, kPinned, state, 0.5, 0.25);
  const VectorXd x = six(1, 2, 3, 4, 5, 6), product = times(*matrix, x);
  for (const double unit : {0x1p-50, 0x1p50})
    expect_entries(times(*matrix, unit * x) / unit, product, 0,
                   "the product with (1, 2, 3, 4, 5, 6) times " + ::testing::PrintToString(unit) +
                       ", over that number, compared with the product with (1, 2, ...)",
                   "powers of two don't round. What is compared with a number that has a unit?");
}

TEST(Masses, KeepsLightMasses) {
  const Spring none(0, 1, GeometricTerm::full);
  const Particles light{Eigen::Vector2d(2e-7, 3e-9), {0, 0}};
  const State state = apart();
  expect_entries(times(*implicit_matrix(none, light, state, 0.1, 0.2), six(1, 1, 1, 1, 1, 1)),
                 six(2e-7, 2e-7, 2e-7, 3e-9, 3e-9, 3e-9), 1e-22,
                 "the product with (1, 1, 1, 1, 1, 1), masses 2e-7 and 3e-9 kg, no forces");
}

TEST(RightSide, IsTheForceAndWhatTheMotionChangesOfIt) {
  const double a = 0.5, b = 0.25;
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  VectorXd rhs = VectorXd::Constant(6, 1e3);
  implicit_rhs(spring, kFree, state, a, b, rhs);
  // The spring pulls by 4 N, and drag by 0.5 v. df/dx v: -4 * 0.75 along the spring, -2 * 1 across it.
  expect_entries(
      rhs, six(a * (4 - 0.25 - b * 3), a * b * 2, 0, a * (-4 + 0.125 + b * 3), a * (-0.5 - b * 2), 0),
      64 * kU, std::string("a (f + b df/dx v), a = 0.5, b = 0.25, for ") + kText, "64 u: rounding");
}

TEST(Cost, TakesOneProductAndOneForce) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  VectorXd rhs = VectorXd::Zero(6);
  implicit_rhs(spring, kFree, state, 0.5, 0.25, rhs);
  EXPECT_COUNT(spring.forces, 1) << "evaluations of the force";
  EXPECT_COUNT(spring.products_x, 1) << "products with df/dx";
  EXPECT_COUNT(spring.products_v, 0) << "products with df/dv";
}

TEST(Pinned, IsZeroWherePinned) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  State state = apart();
  state.v[2] = 0.75;  // no number of the right-hand side is 0 by itself
  state.v[5] = -1;
  VectorXd free(6);
  implicit_rhs(spring, kFree, state, 0.5, 0.25, free);
  for (const Particles& particles : {kPinned, kOtherPinned}) {
    VectorXd rhs = VectorXd::Constant(6, 1e3), expected = free;
    implicit_rhs(spring, particles, state, 0.5, 0.25, rhs);
    expected.segment<3>(particles.is_pinned(0) ? 0 : 3).setZero();
    expect_entries(rhs, expected, 64 * kU,
                   "a (f + b df/dx v) " + pinned_text(particles).substr(2) +
                       ", compared with that of two free ones with 0 in its place: v is all of v, for " +
                       kText,
                   "64 u: rounding");
  }
}

TEST(RightSide, IsTakenAtTheState) {
  const Air air;
  const Eigen::ArrayXd x = air.state.x, v = air.state.v;
  VectorXd rhs = VectorXd::Constant(9, 1e3);
  implicit_rhs(ThickAir(), air.particles, air.state, kA, kB, rhs);
  expect_entries(rhs, kA * (-x.square() * v.cube() - kB * 2 * x * v.cube() * v), 1e-12,
                 "a (f + b df/dx v), " + air.text);
}

TEST(Units, IsTheSameInEveryUnitByImplicitRhs) {
  const State state = apart();
  VectorXd known(6), rhs(6);
  implicit_rhs(Spring(4, 1, GeometricTerm::full, 0.5), kFree, state, 0.5, 0.25, known);
  for (const double unit : {0x1p-50, 0x1p50}) {
    implicit_rhs(Spring(4 * unit, 1, GeometricTerm::full, 0.5 * unit), kFree, state, 0.5, 0.25, rhs);
    expect_entries(rhs / unit, known, 0, "the right-hand side in another unit of mass",
                   "powers of two don't round. What is compared with a number that has a unit?");
  }
}

TEST(Solve, SolvesItsSystem) {
  for (const int size : {3, 30}) {
    Table matrix = counted_table(size, 1);
    const VectorXd right = scattered_vector(size, 1);
    VectorXd rhs = right, dv = VectorXd::Constant(size, 1e3);
    solve_plain(matrix, rhs, 1e-10, 20 * size, dv);
    SCOPED_TRACE(table_text(size, 1, right.norm()) + ", tolerance 1e-10");
    expect_entries(matrix.A * dv, right, 1e-9 * right.norm(),
                   "matrix times dv, compared with the right-hand side", "the tolerance, ten times");
    EXPECT_EQ(rhs, right) << "the right-hand side is another one afterwards";
  }
}

TEST(Report, ReportsWhatItDid) {
  for (const int size : {3, 30}) {
    Table matrix = counted_table(size, 1);
    const VectorXd right = scattered_vector(size, 1);
    VectorXd rhs = right, dv = VectorXd::Constant(size, 1e3);
    const SolveReport report = solve_plain(matrix, rhs, 1e-10, 20 * size, dv);
    SCOPED_TRACE(table_text(size, 1, right.norm()) + ", tolerance 1e-10");
    EXPECT_TRUE(report.converged);
    EXPECT_FALSE(report.preconditioned);
    EXPECT_NUMBER(report.rhs, right.norm(), 1e-12) << "the report's ||right-hand side||";
    EXPECT_NUMBER(report.residual, (right - matrix.A * dv).norm(), 1e-11) << "the report's residual";
    EXPECT_COUNT(matrix.products, 1 + report.steps + report.steps / 64)
        << "products, where the report says " << report.steps << " steps";
  }
}

TEST(Tolerance, KeepsItsToleranceForLightParticles) {
  int before = 0;
  for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
    Table matrix = counted_table(40, 1e-7);
    VectorXd rhs = 1e-9 * scattered_vector(40, 2), dv(40);
    const SolveReport report = solve_plain(matrix, rhs, tolerance, 800, dv);
    SCOPED_TRACE(table_text(40, 1e-7, rhs.norm()) + ", tolerance " + ::testing::PrintToString(tolerance));
    EXPECT_LE((rhs - matrix.A * dv).norm(), (tolerance + 1e-12) * rhs.norm())
        << "||rhs - matrix dv||: ConjGrad's epsilon is the square of what may be left";
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.steps, before) << "iterations: a smaller tolerance takes more";
    before = report.steps;
  }
}

TEST(Report, TakesNoMoreStepsThanItMay) {
  for (const int most : {1, 5}) {
    Table matrix = counted_table(30, 1);
    VectorXd rhs = scattered_vector(30, 1), dv(30);
    const SolveReport report = solve_plain(matrix, rhs, 1e-10, most, dv);
    SCOPED_TRACE(table_text(30, 1, rhs.norm()) + ", tolerance 1e-10");
    EXPECT_COUNT(report.steps, most) << "steps, where ConjGrad needs 30";
    EXPECT_COUNT(matrix.products, 1 + most) << "products: one call of ConjGrad";
    EXPECT_FALSE(report.converged) << "after " << most << " steps";
    EXPECT_NUMBER(report.residual, (rhs - matrix.A * dv).norm(), 1e-11) << "the report's residual";
  }
}

TEST(Nothing, SolvesNothing) {
  Table matrix = counted_table(9, 1);
  VectorXd rhs = VectorXd::Zero(9), dv = VectorXd::Constant(9, 1e3);
  const SolveReport report = solve_plain(matrix, rhs, 1e-10, 180, dv);
  EXPECT_TRUE(dv.isZero(0)) << "dv for a right-hand side of 0";
  EXPECT_COUNT(report.steps, 0);
  EXPECT_NUMBER(report.residual, 0, 0);
  EXPECT_TRUE(report.converged) << "0 <= tolerance * 0";
}

TEST(Report, SaysWhatItCannotSolve) {
  Table matrix = counted_table(9, -1);
  VectorXd rhs = scattered_vector(9, 1), dv(9);
  const SolveReport indefinite = solve_plain(matrix, rhs, 1e-2, 180, dv);
  EXPECT_FALSE(indefinite.converged) << "eigenvalues -1, -2, ...";
  EXPECT_LE(indefinite.steps, 1) << "steps: ConjGrad gives up at once, and so must the solve";
  Table definite = counted_table(9, 1);
  rhs[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_plain(definite, rhs, 1e-2, 180, dv).converged)
      << "a number of the right-hand side is not a number";
}

TEST(Units, IsTheSameInEveryUnitBySolvePlain) {
  const auto in_unit = [](double unit) {
    Table matrix = counted_table(20, 1);
    VectorXd right = unit * scattered_vector(20, 1), dv = VectorXd::Zero(20);
    const SolveReport report = solve_plain(matrix, right, 1e-10, 400, dv);
    return std::pair(VectorXd(dv / unit), report);
  };
  const auto [known, report] = in_unit(1);
  for (const double unit : {0x1p-100, 0x1p100}) {
    const auto [dv, other] = in_unit(unit);
    SCOPED_TRACE(table_text(20, 1, unit));
    EXPECT_COUNT(other.steps, report.steps) << "steps. What is compared with a number that has a unit?";
    EXPECT_EQ(other.converged, report.converged);
    EXPECT_LE((dv - known).norm(), 1e-9 * known.norm()) << "dv in its unit";
  }
}

TEST(Step, MovesWithTheNewVelocity) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  State state = apart(), before = state;
  MatrixXd scratch(6, particles::kImplicitScratch);
  implicit_euler(spring, kFree, 0.5, 1e-10, state, scratch);
  EXPECT_COUNT(spring.forces, 1) << "evaluations of the force";
  EXPECT_GT((state.v - before.v).norm(), 0.1) << "the velocity does not change: is the result in `state`?";
  expect_entries(state.x - before.x, 0.5 * state.v, 64 * kU,
                 std::string("how far x moves: h times the new v, h = 0.5, ") + kText, "64 u: rounding");
}

TEST(Step, TakesTheSameStepHoweverOftenItIsAsked) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const auto step = [&] {
    State state = apart();
    MatrixXd scratch(6, particles::kImplicitScratch);
    implicit_euler(spring, kPinned, 0.5, 1e-10, state, scratch);
    return state;
  };
  const State first = step();
  for (int i = 1; i <= kManyCalls; ++i) {
    const State again = step();
    ASSERT_EQ(again.x, first.x) << "x after the same step, asked again, " << i << " times so far";
    ASSERT_EQ(again.v, first.v) << "v after the same step, asked again, " << i << " times so far";
  }
}

TEST(Pinned, LeavesPinnedParticlesTheirVelocity) {
  Chain chain(1e-3, 5);
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  chain.particles.pinned[3] = 1;
  chain.state.v.head<3>() = Eigen::Vector3d(0.3, -0.2, 0.7);
  State state = chain.state;
  MatrixXd scratch(15, particles::kImplicitScratch);
  implicit_euler(springs, chain.particles, 0.02, 1e-10, state, scratch);
  for (const int i : {0, 3}) {
    SCOPED_TRACE("particle " + std::to_string(i) + " of five in a row on springs, 0 and 3 pinned");
    const VectorXd v = chain.state.v.segment<3>(3 * i), x = chain.state.x.segment<3>(3 * i);
    EXPECT_EQ(VectorXd(state.v.segment<3>(3 * i)), v) << "a pinned particle changed its velocity";
    expect_entries(state.x.segment<3>(3 * i), x + 0.02 * v, 64 * kU, "a pinned particle's position",
                   "64 u: rounding");
  }
}

TEST(Step, SolvesForTheWholeStep) {
  // With a = b = h your own matrix and right-hand side make the system and its solution.
  const double h = 0.5;
  const Spring spring(1, 1.5, GeometricTerm::dropped, 0.1);
  const State before = apart();
  State state = before;
  MatrixXd scratch(6, particles::kImplicitScratch);
  const SolveReport report = implicit_euler(spring, kFree, h, 1e-10, state, scratch);
  VectorXd rhs(6);
  implicit_rhs(spring, kFree, before, h, h, rhs);
  expect_entries(times(*implicit_matrix(spring, kFree, before, h, h), state.v - before.v), rhs, 1e-8,
                 "your matrix times the change of v, compared with your right-hand side, a = b = h = 0.5, "
                 "springs of 1 N/m",
                 "a hundred times the tolerance");
  EXPECT_TRUE(report.converged) << "the report of solve_implicit";
  EXPECT_NUMBER(report.rhs, rhs.norm(), 1e-12) << "the report's ||right-hand side||";
}

TEST(Step, PassesItsToleranceOn) {
  const Chain chain(1e-3, 30);
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  const auto steps = [&](double tolerance) {
    State state = chain.state;
    MatrixXd scratch(90, particles::kImplicitScratch);
    return implicit_euler(springs, chain.particles, 1.0 / 60, tolerance, state, scratch).steps;
  };
  const int coarse = steps(1e-2), fine = steps(1e-10);
  EXPECT_LT(coarse, fine) << "iterations to 1e-2, and to 1e-10: 30 particles in a row, springs of 1e-3 N/m";
}

TEST(Step, DampsAnOscillatorAsBackwardEulerDoes) {
  // 3 kg on a spring, 10 % too long: the amplitude of x and v/w falls by 1/sqrt(1 + h^2 w^2) in each step.
  for (double hw : {0.1, 1.0, 10.0}) {
    const double h = 0.5, w = hw / h;
    const Spring spring(3 * w * w, 1, GeometricTerm::full);
    State state{VectorXd::Zero(6), VectorXd::Zero(6)};
    state.x[3] = 1.1;
    MatrixXd scratch(6, particles::kImplicitScratch);
    implicit_euler(spring, kPinned, h, 1e-10, state, scratch);
    const double amplitude = std::hypot(state.x[3] - 1, state.v[3] / w) / 0.1;
    EXPECT_NUMBER(amplitude, 1 / std::sqrt(1 + hw * hw), 1e-8)
        << "h w = " << hw << "; bound: 1e-10 of the solve, times the condition number, 101 at most";
  }
}

TEST(Step, AMassThatTurnsOnAStiffSpring) {
  const auto step = [](const particles::Force& force, const Particles& particles, double h, State& state) {
    MatrixXd scratch(6, particles::kImplicitScratch);
    implicit_euler(force, particles, h, particles::kSolveTolerance, state, scratch);
  };
  std::printf("Your rows of the text's table:");
  const Revolution full = revolve("full", GeometricTerm::full, step);
  const Revolution filtered = revolve("filtered", GeometricTerm::filtered, step);
  const Revolution dropped = revolve("dropped", GeometricTerm::dropped, step);
  std::puts("");
  EXPECT_NUMBER(full.momentum, 0.0049, 1e-4) << "L/L0 with the full geometric term";
  EXPECT_NUMBER(filtered.momentum, 0.0049, 1e-4) << "L/L0 with the filtered geometric term";
  EXPECT_NUMBER(dropped.momentum, 1, 1e-4) << "L/L0 without the geometric term";
  EXPECT_NUMBER(dropped.length, 0.0055, 1e-4) << "the largest error of the length without it";
}

int main(int argc, char** argv) {
  static const Spring spring(1, 1, GeometricTerm::full);
  static State state = apart();
  static MatrixXd scratch(6, particles::kImplicitScratch);
  static VectorXd dv(6), rhs = VectorXd::Ones(6);
  return run(argc, argv,
             {{"implicit_matrix", [] { implicit_matrix(spring, kFree, state, 1, 1); }},
              {"implicit_rhs", [] { implicit_rhs(spring, kFree, state, 1, 1, dv); }},
              {"solve_plain",
               [] {
                 Table matrix = counted_table(6, 1);
                 solve_plain(matrix, rhs, 1e-10, 100, dv);
               }},
              {"implicit_euler", [] { implicit_euler(spring, kFree, 1, 1e-10, state, scratch); }}});
}
