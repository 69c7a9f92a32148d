// The public checks of H4. Every failure prints the input, what was expected, what came, the error and its bound. The
// contract is in particles/implicit_euler.h. The checks of solve_implicit and implicit_euler need S1.

#include "particles/implicit_euler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check.h"
#include "derivative.h"
#include "particles/preconditioner.h"
#include "particles/springs.h"
#include "stepping.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using hair::GeometricTerm;
using particles::Particles;
using particles::SolveReport;
using particles::State;

namespace {

const double kU = std::ldexp(1.0, -53);

// Two particles of 2 and 3 kg, 2 m apart along x, and a spring of 4 N/m between them that is 1 m long at rest.
const Particles kFree{Eigen::Vector2d(2, 3), {0, 0}}, kPinned{Eigen::Vector2d(2, 3), {1, 0}};

State apart() {
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[3] = 2;
  state.v << 0.5, 0, 0, -0.25, 1, 0;
  return state;
}

const char* const kText =
    "2 and 3 kg at (0, 0, 0) and (2, 0, 0), a spring of 4 N/m that is 1 m long at rest, drag of 0.5 N s/m";

VectorXd times(implicitMatrix& matrix, VectorXd x) {
  const VectorXd before = x;
  VectorXd b = VectorXd::Constant(x.size(), std::numeric_limits<double>::quiet_NaN());
  matrix.matVecMult(x.data(), b.data());
  EXPECT_EQ(x, before) << "matVecMult changed its input";
  return b;
}

VectorXd unit(int i) {
  return VectorXd::Unit(6, i);
}

VectorXd six(double a, double b, double c, double d, double e, double f) {
  VectorXd values(6);
  values << a, b, c, d, e, f;
  return values;
}

// 60 particles of 1e-7 kg, 1 cm apart along x, the first one pinned; springs between them, of 1e-3 N/m if nothing else is said,
// the first one stretched by 1 mm. With h = 1/60 s, h^2 k/m is 2.8.
struct Chain {
  static constexpr int kCount = 60;
  Particles particles{VectorXd::Constant(kCount, 1e-7), std::vector<char>(kCount, 0)};
  State state{VectorXd::Zero(3 * kCount), VectorXd::Zero(3 * kCount)};
  std::vector<particles::Spring> springs;

  explicit Chain(double stiffness = 1e-3) {
    particles.pinned[0] = 1;
    for (int i = 1; i < kCount; ++i) {
      state.x[3 * i] = 0.01 * i + 0.001;
      springs.push_back({i - 1, i, stiffness, 0.01});
    }
  }
};

const char* const kChainText =
    "60 particles of 1e-7 kg in a row, 1 cm apart, springs of 1e-3 N/m, the first one stretched by 1 mm";

// The chain's springs, which know their band: that of their products, of straight hair.
class BandedSprings : public particles::DampedSprings {
 public:
  explicit BandedSprings(const std::vector<particles::Spring>& springs)
      : DampedSprings(springs, particles::Products::definite), springs_(springs) {}

  bool add_band(particles::Input x, particles::Input, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch) const override {
    for (const particles::Spring& spring : springs_) {
      const Eigen::Vector3d e = x.segment<3>(3 * spring.j) - x.segment<3>(3 * spring.i);
      const Eigen::Matrix3d along = e * e.transpose() / e.squaredNorm();
      const double turn = std::max(1 - spring.rest_length / e.norm(), 0.0);
      const Eigen::Matrix3d K = spring.stiffness * (along + turn * (Eigen::Matrix3d::Identity() - along));
      band.block(spring.i, 0) -= by_dfdx * K;
      band.block(spring.j, 0) -= by_dfdx * K;
      band.block(spring.j, 1) += by_dfdx * K;
    }
    return true;
  }

 private:
  std::vector<particles::Spring> springs_;
};

// The matrix as a table, by products with unit vectors.
MatrixXd table(const particles::Force& force, const Particles& particles, const State& state, double a,
               double b) {
  auto matrix = implicit_matrix(force, particles, state, a, b);
  MatrixXd A(state.x.size(), state.x.size());
  for (int j = 0; j < A.cols(); ++j) A.col(j) = times(*matrix, VectorXd::Unit(A.cols(), j));
  return A;
}

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
  for (const Particles& particles : {kFree, kPinned}) {
    const MatrixXd A = table(spring, particles, apart(), 0.5, 0.25);
    EXPECT_LE((A - A.transpose()).cwiseAbs().maxCoeff(), 32 * kU)
        << "A =\n"
        << A << "\nfor " << kText << "; bound: 32 u, rounding";
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
  for (const Particles& particles : {kFree, kPinned}) {
    const Spring spring(4, 1, GeometricTerm::full, 0.5);
    const State state = apart();
    const double a = 0.5, b = 0.25;
    const MatrixXd A = table(spring, particles, state, a, b);
    VectorXd rhs = VectorXd::Zero(6);
    spring.add_force(state.x, state.v, rhs);
    spring.add_dfdx(state.x, state.v, VectorXd(b * state.v), rhs);
    rhs *= a;
    if (particles.is_pinned(0)) rhs.head<3>().setZero();
    VectorXd dv = VectorXd::Constant(6, 1e3);
    MatrixXd scratch = MatrixXd::Constant(6, particles::kImplicitScratch, 1e3);
    const int before = spring.forces;
    const SolveReport report = solve_implicit(spring, particles, state, a, b, 1e-10, dv, scratch);
    const std::string what =
        std::string(particles.is_pinned(0) ? "particle 0 pinned, " : "both free, ") + kText;
    expect_entries(A * dv, rhs, 1e-10 * rhs.norm() + 4096 * kU * A.norm(),
                   "matrix times dv, beside a (f + b df/dx v), a = 0.5, b = 0.25, " + what,
                   "1e-10 ||rhs|| + 4096 u ||A||: tolerance and rounding, see solver/linearSolver.h");
    EXPECT_EQ(spring.forces - before, 1) << "evaluations of the force";
    EXPECT_TRUE(report.converged) << what;
    EXPECT_NEAR(report.rhs, rhs.norm(), 1e-12) << "the report's ||right-hand side||, " << what;
    EXPECT_LE(report.residual, 1e-10 * rhs.norm()) << "the report's residual, " << what;
  }
}

TEST(SolveImplicit, KeepsItsToleranceForLightParticles) {
  const Chain chain;
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  const double h = 1.0 / 60;
  const MatrixXd A = table(springs, chain.particles, chain.state, h, h);
  VectorXd rhs = VectorXd::Zero(A.rows());  // v = 0: h f
  springs.add_force(chain.state.x, chain.state.v, rhs);
  rhs *= h;
  rhs.head<3>().setZero();
  int steps_before = 0;
  for (double tolerance : {1e-2, 1e-6, 1e-10}) {
    VectorXd dv = VectorXd::Constant(A.rows(), 1e3);
    MatrixXd scratch = MatrixXd::Constant(A.rows(), particles::kImplicitScratch, 1e3);
    const SolveReport report =
        solve_implicit(springs, chain.particles, chain.state, h, h, tolerance, dv, scratch);
    SCOPED_TRACE(std::string(kChainText) + ", a = b = 1/60 s, tolerance " +
                 ::testing::PrintToString(tolerance));
    const double left = (rhs - A * dv).norm(), rounding = 4096 * kU * A.norm() * dv.norm();
    EXPECT_LE(left, tolerance * rhs.norm() + rounding)
        << "||rhs - matrix dv||, where ||rhs|| is " << rhs.norm()
        << ": ConjGrad's epsilon is the square of what may be left";
    EXPECT_NEAR(report.residual, left, rounding + 1e-6 * left) << "the report's residual";
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.steps, steps_before) << "iterations: a smaller tolerance takes more";
    steps_before = report.steps;
  }
}

TEST(SolveImplicit, TakesFewStepsWithAPreconditioner) {
  // h^2 k/m is 2.8e6: conjugate gradients alone take hundreds of steps.
  const Chain chain(1e3);
  const BandedSprings springs(chain.springs);
  const double h = 1.0 / 60, tolerance = particles::kSolveTolerance;
  const MatrixXd A = table(springs, chain.particles, chain.state, h, h);
  VectorXd rhs = VectorXd::Zero(A.rows());  // v = 0: h f
  springs.add_force(chain.state.x, chain.state.v, rhs);
  rhs *= h;
  rhs.head<3>().setZero();
  VectorXd dv = VectorXd::Constant(A.rows(), 1e3);
  MatrixXd scratch = MatrixXd::Constant(A.rows(), particles::kImplicitScratch, 1e3);
  const SolveReport report =
      solve_implicit(springs, chain.particles, chain.state, h, h, tolerance, dv, scratch);
  SCOPED_TRACE("60 particles of 1e-7 kg in a row, springs of 1e3 N/m that know their band, a = b = 1/60 s");
  EXPECT_TRUE(report.preconditioned) << "the report says that there was no preconditioner: "
                                        "particles::Preconditioner exists for these forces";
  EXPECT_LE(report.steps, 2 * particles::kMostSolves) << "iterations: the preconditioner is the matrix, but "
                                                         "for rounding, so that each solve takes two at most";
  EXPECT_LE((rhs - A * dv).norm(), tolerance * rhs.norm() + 0x1p-48 * (A.norm() * dv.norm() + rhs.norm()))
      << "||rhs - matrix dv||; bound: the tolerance, and 2^-48 (||matrix|| ||dv|| + ||rhs||), rounding";
  EXPECT_TRUE(report.converged);
}

TEST(SolveImplicit, SaysWhatItCannotSolve) {
  // A number that is not finite can't be solved for; nothing to solve is solved.
  Chain chain;
  const particles::DampedSprings springs(chain.springs, particles::Products::definite);
  VectorXd dv = VectorXd::Zero(chain.state.x.size());
  MatrixXd scratch = MatrixXd::Zero(dv.size(), particles::kImplicitScratch);
  chain.state.x[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_implicit(springs, chain.particles, chain.state, 0.1, 0.1, 1e-10, dv, scratch).converged)
      << "a position is not a number, and yet the report says that the solve converged";

  // 1 m of spring pressed to 0.5 m: across it, the matrix of a = b = 1 s is 2 - 100 (2 - 1) < 0 for the free particle.
  const Spring pressed(100, 1, GeometricTerm::full);
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[3] = 0.5;
  state.v << 0, 0, 0, 0.5, 1, 0;
  const MatrixXd A = table(pressed, kPinned, state, 1, 1);
  VectorXd six_dv = VectorXd::Zero(6), rhs = VectorXd::Zero(6);
  pressed.add_force(state.x, state.v, rhs);
  pressed.add_dfdx(state.x, state.v, state.v, rhs);
  rhs.head<3>().setZero();
  MatrixXd small = MatrixXd::Zero(6, particles::kImplicitScratch);
  const SolveReport report = solve_implicit(pressed, kPinned, state, 1, 1, 1e-10, six_dv, small);
  ASSERT_TRUE(six_dv.allFinite()) << "dv, where the matrix is not positive definite";
  EXPECT_TRUE(!report.converged || (A * six_dv - rhs).norm() <= 1e-9 * rhs.norm())
      << "the matrix is not positive definite, ||rhs - matrix dv|| is " << (A * six_dv - rhs).norm() << " of "
      << rhs.norm() << ", and yet the report says that the solve converged";
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
