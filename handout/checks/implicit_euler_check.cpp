// The public checks of H4. Every failure prints the input, what was expected, what came, the error and its bound. The
// contract is in particles/implicit_euler.h. The checks of solve_implicit and implicit_euler need S1.

#include "particles/implicit_euler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "check.h"
#include "derivative.h"
#include "implicit_systems.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "stepping.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using hair::GeometricTerm;
using particles::Particles;
using particles::SolveReport;
using particles::State;

namespace {

const double kU = std::ldexp(1.0, -53), kStep = 1.0 / 60;

// Two particles of 2 and 3 kg, 2 m apart along x, and a spring of 4 N/m between them that is 1 m long at rest.
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

const char* const kChainText =
    "60 particles of 1e-7 kg in a row, 1 cm apart, springs of 1e-3 N/m, the first one stretched by 1 mm";

}  // namespace

TEST(ImplicitMatrix, IsTheMassesWhereNothingActs) {
  const Spring none(0, 1, GeometricTerm::full);
  expect_entries(times(*implicit_matrix(none, kFree, apart(), 0.1, 0.1), six(1, 2, 3, 4, 5, 6)),
                 six(2, 4, 6, 12, 15, 18), 0, "the product of M with (1, 2, 3, 4, 5, 6), masses 2 and 3 kg",
                 "small integers don't round");
}

TEST(ImplicitMatrix, SubtractsBothDerivatives) {
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

TEST(ImplicitMatrix, HasPinnedRowsAndColumnsOfTheIdentity) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  const State state = apart();
  auto matrix = implicit_matrix(spring, kPinned, state, 0.5, 0.25);
  expect_entries(times(*matrix, six(1, 2, 3, 0, 0, 0)), six(1, 2, 3, 0, 0, 0), 0,
                 std::string("the product with (1, 2, 3, 0, 0, 0), particle 0 pinned, for ") + kText,
                 "ones and zeros don't round");
  expect_entries(
      times(*matrix, six(1, 2, 3, 1, 0, 0)), six(1, 2, 3, 3.75, 0, 0), 32 * kU,
      std::string("the product with (1, 2, 3, 1, 0, 0), particle 0 pinned, which must not matter to "
                  "particle 1, for ") +
          kText,
      "32 u: rounding");
}

TEST(ImplicitMatrix, IsSymmetric) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  for (const Particles& particles : {kFree, kPinned, kOtherPinned}) {
    const MatrixXd A = table(spring, particles, apart(), 0.5, 0.25);
    EXPECT_LE((A - A.transpose()).cwiseAbs().maxCoeff(), 32 * kU)
        << "A =\n"
        << A << "\nfor " << kText << pinned_text(particles) << "; bound: 32 u, rounding";
  }
}

TEST(ImplicitMatrix, TakesOneProductOfEachKind) {
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

TEST(SolveImplicit, SolvesItsSystem) {
  for (const Particles& particles : {kFree, kPinned, kOtherPinned}) {
    const Spring spring(4, 1, GeometricTerm::full, 0.5);
    const State state = apart();
    const double a = 0.5, b = 0.25;
    const MatrixXd A = table(spring, particles, state, a, b);
    const VectorXd rhs = right_side(spring, particles, state, a, b);
    VectorXd dv = VectorXd::Constant(6, 1e3);
    MatrixXd scratch = MatrixXd::Constant(6, particles::kImplicitScratch, 1e3);
    const int before = spring.forces;
    const SolveReport report = solve_implicit(spring, particles, state, a, b, 1e-10, dv, scratch);
    const std::string what = kText + pinned_text(particles);
    expect_entries(A * dv, rhs, 1e-10 * rhs.norm() + 4096 * kU * A.norm(),
                   "matrix times dv, beside a (f + b df/dx v), a = 0.5, b = 0.25, " + what,
                   "1e-10 ||rhs|| + 4096 u ||A||: tolerance and rounding, see solver/linearSolver.h");
    EXPECT_EQ(spring.forces - before, 1) << "evaluations of the force";
    EXPECT_TRUE(report.converged) << what;
    EXPECT_NEAR(report.rhs, rhs.norm(), 1e-12) << "the report's ||right-hand side||, " << what;
    EXPECT_LE(report.residual, 1e-10 * rhs.norm()) << "the report's residual, " << what;
  }
}

TEST(SolveImplicit, TakesDerivativesAtTheState) {
  const double a = 0.5, b = 0.25;
  const State state{six(1, 0.5, 2, 1.5, -1, 0.5), six(0.5, 1, 0.25, 1, -0.5, 2)};
  VectorXd dv = VectorXd::Constant(6, 1e3), expected(6), rhs(6);
  for (int i = 0; i < 6; ++i) {
    const double x = state.x[i], v = state.v[i], m = kFree.mass[i / 3];
    const double f = -x * x * v * v * v, dfdx = -2 * x * v * v * v, dfdv = -3 * x * x * v * v;
    rhs[i] = a * (f + b * dfdx * v);
    expected[i] = rhs[i] / (m - a * dfdv - a * b * dfdx);
  }
  MatrixXd scratch = MatrixXd::Constant(6, particles::kImplicitScratch, 1e3);
  solve_implicit(ThickAir(), kFree, state, a, b, 1e-10, dv, scratch);
  expect_entries(dv, expected, 1e-10 * rhs.norm(),
                 "dv for f = -x^2 v^3, entry by entry, masses 2 and 3 kg, a = 0.5, b = 0.25, at x = " +
                     particles_in_words(state.x) + ", v = " + particles_in_words(state.v),
                 "1e-10 ||rhs||: the tolerance, and no eigenvalue of the matrix is below 2");
}

TEST(SolveImplicit, KeepsItsToleranceForLightParticles) {
  const Chain chain;
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  int steps_before = 0;
  for (double tolerance : {1e-2, 1e-6, 1e-10}) {
    const Solved system = solved(springs, chain.particles, chain.state, kStep, tolerance);
    SCOPED_TRACE(std::string(kChainText) + ", a = b = 1/60 s, tolerance " +
                 ::testing::PrintToString(tolerance));
    EXPECT_LE(system.left(), tolerance * system.rhs.norm() + system.rounding())
        << "||rhs - matrix dv||, where ||rhs|| is " << system.rhs.norm()
        << ": ConjGrad's epsilon is the square of what may be left";
    EXPECT_NEAR(system.report.residual, system.left(), system.rounding() + 1e-6 * system.left())
        << "the report's residual";
    EXPECT_TRUE(system.report.converged);
    EXPECT_FALSE(system.report.preconditioned) << "these springs don't know their band";
    EXPECT_GT(system.report.steps, steps_before) << "iterations: a smaller tolerance takes more";
    steps_before = system.report.steps;
  }
}

// With a preconditioner: springs between neighbours know their band, ties between others do not.
namespace {

void expect_solved(const Solved& system, double tolerance) {
  EXPECT_TRUE(system.report.preconditioned) << "the report says that there was no preconditioner: "
                                               "particles::Preconditioner exists for these forces";
  EXPECT_LE(system.left(), tolerance * system.rhs.norm() + system.rounding())
      << "||rhs - matrix dv||; bound: the tolerance, and 2^-48 (||matrix|| ||dv|| + ||rhs||), rounding";
  EXPECT_NEAR(system.report.residual, system.left(), system.rounding())
      << "the report's residual: that of dv, computed anew, and not that of L^-1 r";
  EXPECT_NEAR(system.report.rhs, system.rhs.norm(), 1e-12 * system.rhs.norm())
      << "the report's ||right-hand side||";
  EXPECT_TRUE(system.report.converged) << "after " << system.report.steps << " steps";
  expect_all_steps_reported(system);
}

// Tied, and each particle but the root off by up to 1 mm.
Chain tied_chain(double tie, double rest_length) {
  Chain chain(3.6);
  chain.state.x.tail(177) += 1e-3 * scattered_vector(177, 3);
  chain.tie(tie, rest_length);
  return chain;
}

}  // namespace

TEST(SolveImplicit, TakesFewStepsWithAPreconditioner) {
  // h^2 k/m is 2.8e6: conjugate gradients alone take hundreds of steps.
  const Chain chain(1e3);
  const Solved system = solved(BandedSprings(chain.springs), chain.particles, chain.state, kStep, 1e-10);
  SCOPED_TRACE("60 particles of 1e-7 kg in a row, springs of 1e3 N/m that know their band, a = b = 1/60 s");
  expect_solved(system, 1e-10);
  EXPECT_LE(system.report.steps, 2 * particles::kMostSolves)
      << "iterations: the preconditioner is the matrix, but "
         "for rounding, so that each solve takes two at most";
}

TEST(SolveImplicit, IsContentWithWhatRoundingAllows) {
  // A slow wave: the springs' forces on a particle nearly cancel, so that the right-hand side is a thousandth of ||matrix|| ||dv||,
  // and no solve comes as near to it as the tolerance asks.
  Chain chain(1e3);
  for (int i = 1; i < chain.particles.count(); ++i) {
    chain.state.x[3 * i] = 0.01 * i;
    chain.state.v[3 * i] = 1e-6 * std::sin(std::numbers::pi * i / 119);
  }
  const double tolerance = 1e-15;
  const Solved system = solved(BandedSprings(chain.springs), chain.particles, chain.state, kStep, tolerance);
  SCOPED_TRACE(
      "60 particles of 1e-7 kg in a row, springs of 1e3 N/m that know their band, velocities of at most 1e-6 "
      "m/s along the row, "
      "a = b = 1/60 s, tolerance 1e-15");
  EXPECT_LE(system.left(), system.rounding())
      << "||rhs - matrix dv||; bound: 2^-48 (||matrix|| ||dv|| + ||rhs||)";
  EXPECT_TRUE(system.report.converged)
      << "the residual is " << system.report.residual << ", " << system.report.residual / system.report.rhs
      << " of the right-hand side; Preconditioner::rounding_allows says for the norms of dv and of the "
         "right-hand side whether that is enough";
}

TEST(SolveImplicit, SolvesAgainForWhatIsLeft) {
  // The ties are as stiff as the chain is, and one solve of at most 180 steps is not enough.
  const Chain chain = tied_chain(1, 0.06);
  SCOPED_TRACE(
      "60 particles of 1e-7 kg, a chain of 3.6 N/m, ties of 1 N/m that the preconditioner does not know");
  for (const double tolerance : {1e-10, 1e-12})
    expect_solved(solved(BandedSprings(chain.springs), chain.particles, chain.state, kStep, tolerance),
                  tolerance);
}

TEST(SolveImplicit, SolvesOnceWhereThatIsEnough) {
  const Chain chain = tied_chain(0.1, 0.07);
  SCOPED_TRACE(
      "60 particles of 1e-7 kg, a chain of 3.6 N/m, ties of 0.1 N/m that the preconditioner does not know");
  const BandedSprings springs(chain.springs);
  const Solved coarse = solved(springs, chain.particles, chain.state, kStep, 1e-4),
               fine = solved(springs, chain.particles, chain.state, kStep, 1e-10);
  expect_solved(fine, 1e-10);
  EXPECT_LE(fine.report.steps, 100)
      << "iterations: each of the 53 ties adds little to the matrix, and one solve is enough";
  EXPECT_LT(coarse.report.steps, fine.report.steps) << "iterations to 1e-4, and to 1e-10";
}

TEST(SolveImplicit, TakesTheStepsThatItNeeds) {
  // h^2 k/m is 1e4, and springs are stretched in all directions.
  const Chain chain = [] {
    Chain stretched(3.6);
    stretched.state.x += 1e-3 * scattered_vector(stretched.state.x.size(), 3);
    return stretched;
  }();
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  const Solved system = solved(springs, chain.particles, chain.state, kStep, 1e-10);
  SCOPED_TRACE("60 particles of 1e-7 kg, springs of 3.6 N/m that do not know their band: some 160 steps");
  EXPECT_LE(system.left(), 1e-10 * system.rhs.norm() + system.rounding());
  EXPECT_TRUE(system.report.converged)
      << "ConjGrad may take max(100, 20 * 3n) steps. It took " << system.report.steps;
  expect_all_steps_reported(system);
}

TEST(SolveImplicit, TakesAllStepsThatItMay) {
  // Between any two of 33 particles a tie, from h^2 k/m = 1 to 1e6, and a tolerance that no solve reaches.
  Chain tangle(3.6, 33);
  const VectorXd numbers = scattered_vector(33 * 33, 2);
  tangle.state.x += 1e-3 * scattered_vector(99, 3);
  for (int i = 0; i < 33; ++i)
    for (int j = i + 2; j < 33; ++j)
      tangle.springs.push_back({i, j, 3.6e-4 * std::pow(1e3, 1 + numbers[33 * i + j]), 0.01 * (j - i)});
  const Solved system = solved(BandedSprings(tangle.springs), tangle.particles, tangle.state, kStep, 0);
  SCOPED_TRACE("33 particles, a tie between any two, tolerance 0");
  EXPECT_TRUE(system.report.steps % 100 == 0 && system.report.steps <= 100 * particles::kMostSolves)
      << system.report.steps << " steps: max(100, 3n) in each of at most " << particles::kMostSolves
      << " solves";
  expect_all_steps_reported(system);
}

TEST(SolveImplicit, IsTheSameInEveryUnit) {
  // Masses of 2^-20 kg and lengths of 2^10 m or the like make powers of two of all numbers, and rounding stays the same.
  const auto in_units = [](double mass, double length, double tolerance) {
    Chain chain = tied_chain(0.1, 0.07);
    chain.particles.mass *= mass;
    chain.particles.pinned[0] = 0;
    chain.state.x *= length;
    for (particles::Spring& spring : chain.springs) spring.stiffness *= mass, spring.rest_length *= length;
    Solved system = solved(BandedSprings(chain.springs), chain.particles, chain.state, kStep, tolerance);
    system.dv /= length;
    return system;
  };
  for (const double tolerance : {1e-10, 0.0}) {
    const Solved known = in_units(1, 1, tolerance);
    for (const double mass : {0x1p-20, 0x1p20})
      for (const double length : {0x1p-10, 0x1p10}) {
        const Solved same = in_units(mass, length, tolerance);
        SCOPED_TRACE("with masses times " + ::testing::PrintToString(mass) + " and lengths times " +
                     ::testing::PrintToString(length) + ", tolerance " + ::testing::PrintToString(tolerance));
        EXPECT_EQ(same.report.steps, known.report.steps)
            << "steps. What is compared with a number that has a unit?";
        EXPECT_EQ(same.report.converged, known.report.converged);
        EXPECT_LE((same.dv - known.dv).norm(), 1e-6 * known.dv.norm());
      }
  }
}

TEST(SolveImplicit, SolvesNothing) {
  Chain chain(1e3);
  chain.particles.pinned.assign(60, 1);
  const particles::DampedSprings plain(chain.springs, particles::Products::definite);
  const BandedSprings banded(chain.springs);
  for (const particles::Force* force :
       {static_cast<const particles::Force*>(&plain), static_cast<const particles::Force*>(&banded)}) {
    const Solved system = solved(*force, chain.particles, chain.state, kStep, 1e-10);
    EXPECT_TRUE(system.dv.isZero(0)) << "all particles are pinned";
    EXPECT_EQ(system.report.steps, 0);
    EXPECT_EQ(system.report.residual, 0);
    EXPECT_TRUE(system.report.converged) << "0 <= tolerance * 0";
  }
}

TEST(SolveImplicit, SaysWhatItCannotSolve) {
  // A number that is not finite can't be solved for.
  Chain chain;
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  VectorXd dv = VectorXd::Zero(chain.state.x.size());
  MatrixXd scratch = MatrixXd::Zero(dv.size(), particles::kImplicitScratch);
  chain.state.x[7] = std::numeric_limits<double>::quiet_NaN();
  const SolveReport none =
      solve_implicit(springs, chain.particles, chain.state, 0.1, 0.1, 1e-10, dv, scratch);
  EXPECT_FALSE(none.converged)
      << "a position is not a number, and yet the report says that the solve converged";
  EXPECT_LE(none.steps, 1) << "a position is not a number: ConjGrad gives up, and so must the solve";

  // 1 m of spring pressed to 0.5 m: across it, the matrix of a = b = 1 s is 3 - 100 (2 - 1) < 0 for the free particle.
  const Spring pressed(100, 1, GeometricTerm::full);
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[3] = 0.5;
  state.v << 0, 0, 0, 0.5, 1, 0;
  const Solved system = solved(pressed, kPinned, state, 1, 1e-10);
  ASSERT_TRUE(system.dv.allFinite()) << "dv, where the matrix is not positive definite";
  EXPECT_TRUE(!system.report.converged || system.left() <= 1e-9 * system.rhs.norm())
      << "the matrix is not positive definite, ||rhs - matrix dv|| is " << system.left() << " of "
      << system.rhs.norm() << ", and yet the report says that the solve converged";
  EXPECT_LE(system.report.steps, 2) << "steps. The matrix has two different eigenvalues, one of which is "
                                       "negative: ConjGrad breaks down in the second "
                                       "step at the latest, and there is no use in calling it again";
}

// Without a preconditioner rounding leaves more than the tolerance where h^2 k/m is 3e13 and a bent chain can fold.
TEST(SolveImplicit, SaysWhereRoundingKeepsItFromItsTolerance) {
  const int most = 20 * 60;
  int longest = 0;
  for (int which : {1, 2, 3}) {
    Chain chain(1e10, 20);
    chain.state.x.tail(57) += 3e-3 * scattered_vector(57, which);
    chain.particles.mass.array() *= 1 + 0.4 * scattered_vector(20, which + 5).array();
    for (particles::Spring& spring : chain.springs)
      spring.rest_length =
          (chain.state.x.segment<3>(3 * spring.j) - chain.state.x.segment<3>(3 * spring.i)).norm();
    particles::ForceSum force;
    force.emplace<particles::DampedSprings>(chain.springs, particles::Products::definite);
    force.emplace<particles::Gravity>(chain.particles.mass, Eigen::Vector3d(0, 0, -9.81));
    SCOPED_TRACE("20 particles of some 1e-7 kg in a bent chain of 1e10 N/m under gravity, a = b = 1/60 s");
    const Solved fine = solved(force, chain.particles, chain.state, kStep, 1e-10),
                 loose = solved(force, chain.particles, chain.state, kStep, 1e-6);
    EXPECT_FALSE(fine.report.converged) << "tolerance 1e-10";
    EXPECT_TRUE(fine.dv.allFinite());
    EXPECT_LE(fine.report.steps, 3 * most) << "steps of ConjGrad, 20 * 3n in a call, to 1e-10, 1e-8 and 1e-6";
    EXPECT_LE(loose.report.steps, most) << "steps to 1e-6: no larger tolerance is tried";
    expect_all_steps_reported(fine);
    if (!loose.report.converged) longest = std::max(longest, loose.report.steps);
  }
  EXPECT_TRUE(longest == 0 || longest == most) << longest << " steps, where ConjGrad may take " << most;
}

TEST(ImplicitEuler, MovesWithTheNewVelocity) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  State state = apart(), before = state;
  MatrixXd scratch(6, particles::kImplicitScratch);
  implicit_euler(spring, kFree, 0.5, 1e-10, state, scratch);
  EXPECT_GT((state.v - before.v).norm(), 0.1) << "the velocity does not change: is the result in `state`?";
  expect_entries(state.x, before.x + 0.5 * state.v, 64 * kU,
                 std::string("x + h times the new v, h = 0.5, ") + kText, "64 u: rounding");
}

TEST(ImplicitEuler, TakesTheSameStepHoweverOftenItIsAsked) {
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

TEST(ImplicitEuler, LeavesPinnedParticlesTheirVelocity) {
  const Spring spring(4, 1, GeometricTerm::full, 0.5);
  State state = apart(), before = state;
  MatrixXd scratch(6, particles::kImplicitScratch);
  implicit_euler(spring, kPinned, 0.5, 1e-10, state, scratch);
  EXPECT_EQ(state.v.head<3>(), before.v.head<3>()) << "a pinned particle changed its velocity";
  expect_entries(state.x.head<3>(), before.x.head<3>() + 0.5 * before.v.head<3>(), 64 * kU,
                 "a pinned particle's position", "64 u: rounding");
}

TEST(ImplicitEuler, DampsAnOscillatorAsBackwardEulerDoes) {
  // 3 kg on a spring, 10 % too long: the amplitude of x and v/w falls by 1/sqrt(1 + h^2 w^2) in each step.
  for (double hw : {0.1, 1.0, 10.0}) {
    const double h = 0.5, w = hw / h;
    const Spring spring(3 * w * w, 1, GeometricTerm::full);
    State state{VectorXd::Zero(6), VectorXd::Zero(6)};
    state.x[3] = 1.1;
    MatrixXd scratch(6, particles::kImplicitScratch);
    implicit_euler(spring, kPinned, h, 1e-10, state, scratch);
    const double amplitude = std::hypot(state.x[3] - 1, state.v[3] / w) / 0.1;
    EXPECT_NEAR(amplitude, 1 / std::sqrt(1 + hw * hw), 1e-8)
        << "h w = " << hw << "; bound: 1e-10 of the solve, times the condition number, 101 at most";
  }
}

TEST(ImplicitEuler, AMassThatTurnsOnAStiffSpring) {
  const auto step = [](const particles::Force& force, const Particles& particles, double h, State& state) {
    MatrixXd scratch(6, particles::kImplicitScratch);
    implicit_euler(force, particles, h, particles::kSolveTolerance, state, scratch);
  };
  std::printf("One revolution, h = 1/60 s, k/m = 1e8 / s^2: your rows of the table in the assignment\n");
  const Revolution full = revolve("linearly implicit, full geometric term", GeometricTerm::full, step);
  const Revolution filtered = revolve("linearly implicit, filtered", GeometricTerm::filtered, step);
  const Revolution dropped = revolve("linearly implicit, dropped", GeometricTerm::dropped, step);
  EXPECT_NEAR(full.momentum, 0.0049, 1e-4) << "L/L0 with the full geometric term";
  EXPECT_NEAR(filtered.momentum, 0.0049, 1e-4) << "L/L0 with the filtered geometric term";
  EXPECT_NEAR(dropped.momentum, 1, 1e-4) << "L/L0 without the geometric term";
  EXPECT_NEAR(dropped.length, 0.0055, 1e-4) << "the largest error of the length without it";
}

int main(int argc, char** argv) {
  static const Spring spring(1, 1, GeometricTerm::full);
  static State state = apart();
  static MatrixXd scratch(6, particles::kImplicitScratch);
  static VectorXd dv(6);
  return run(
      argc, argv,
      {{"implicit_matrix", "ImplicitMatrix", [] { implicit_matrix(spring, kFree, state, 1, 1); }},
       {"solve_implicit", "SolveImplicit",
        [] { solve_implicit(spring, kFree, state, 1, 1, 1e-10, dv, scratch); }},
       {"implicit_euler", "ImplicitEuler", [] { implicit_euler(spring, kFree, 1, 1e-10, state, scratch); }}});
}
