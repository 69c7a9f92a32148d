// The public checks of H6. Every failure prints the input, what was expected, what came, the error and its bound. The
// contract is in hair/predictor_corrector.h. They need S1, H4 and H5.

#include "hair/predictor_corrector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "check.h"
#include "derivative.h"
#include "implicit_systems.h"
#include "stepping.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::GeometricTerm;
using hair::StepReport;
using hair::Strand;
using particles::Particles;
using particles::State;

namespace {

const double kU = std::ldexp(1.0, -53), kTick = 1.0 / 60;

// A root and a particle of 2 kg, 1 m apart at rest.
Strand two() {
  Strand strand;
  strand.mass = Eigen::Vector2d(2, 2);
  strand.rest_length = VectorXd::Ones(1);
  return strand;
}

const Particles kTwo{Eigen::Vector2d(2, 2), {1, 0}};

// At rest length along x, moving with (1, 2, 0) m/s.
State moving() {
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[3] = 1;
  state.v[3] = 1;
  state.v[4] = 2;
  return state;
}

StepReport step(const particles::Force& force, double h, State& state) {
  MatrixXd scratch = MatrixXd::Constant(6, hair::kPredictorCorrectorScratch, 1e3);
  return predictor_corrector(force, kTwo, two(), h, 1e-10, state, scratch);
}

VectorXd six(const Vector3d& root, const Vector3d& other) {
  VectorXd values(6);
  values << root, other;
  return values;
}

}  // namespace

namespace {

constexpr double kHalf = 0.5;  // s, of the steps below

// After a step without forces the particle is at length 1, and has the velocity that leads there from (1, 0).
const Vector3d kFree = Vector3d(1.5, 1, 0).normalized();

// h^2 k/m = 1: every step shows. The spring is at rest length along x, so that in step 1 df/dx is -k along x.
constexpr double kStiffness = 8, kRatio = kHalf * kHalf * kStiffness / 2;  // 1

struct FiveSteps {
  Vector3d x, v;
};

FiveSteps five_steps() {
  const Vector3d v1(1 + -kRatio * 1 / (2 + kRatio), 2, 0);  // (2 + ratio) dv = h/2 (0 - h k 1)
  const Vector3d predicted = Vector3d(1, 0, 0) + kHalf * v1, u = predicted.normalized();
  const Vector3d v2 = v1 + (u - predicted) / kHalf;
  return {u, v2 - kRatio * u.dot(v2) / (2 + kRatio) * u};  // the force at x~ is 0
}

State after(double stiffness, GeometricTerm term) {
  State state = moving();
  step(Spring(stiffness, 1, term), kHalf, state);
  return state;
}

}  // namespace

TEST(Lengths, WithoutForcesGoesToTheRightLength) {
  expect_entries(after(0, GeometricTerm::full).x, six(Vector3d::Zero(), kFree), 1e-11,
                 "x after a step of 0.5 s without forces, from (1, 0, 0) m at (1, 2, 0) m/s, length 1 m",
                 "ten times the tolerance of lengths", moving().x);
}

TEST(Prediction, MovesWithThePredictedVelocity) {
  // The rest length is the length that step 2 leads to: nothing is corrected.
  const Vector3d predicted = Vector3d(1, 0, 0) + kHalf * Vector3d(1 - kRatio / (2 + kRatio), 2, 0);
  Strand strand = two();
  strand.rest_length[0] = predicted.norm();
  State state = moving();
  MatrixXd scratch = MatrixXd::Constant(6, hair::kPredictorCorrectorScratch, 1e3);
  predictor_corrector(Spring(kStiffness, 1, GeometricTerm::dropped), kTwo, strand, kHalf, 1e-10, state,
                      scratch);
  expect_entries(
      state.x, six(Vector3d::Zero(), predicted), 1e-9,
      "x after a step of 0.5 s from (1, 0, 0) m at (1, 2, 0) m/s, 2 kg, a spring of 8 N/m and 1 m, where "
      "the length is right after step 2",
      "1e-10 of the solves, ten times");
}

TEST(Prediction, PutsASpringWhereTheFiveStepsDo) {
  look_at("after");
  expect_entries(after(kStiffness, GeometricTerm::dropped).x, six(Vector3d::Zero(), five_steps().x), 1e-9,
                 "x after a step of 0.5 s from (1, 0, 0) m at (1, 2, 0) m/s, 2 kg, a spring of 8 N/m and 1 m",
                 "1e-10 of the solves, ten times");
}

TEST(Impulse, WithoutForcesGivesTheImpulse) {
  expect_entries(after(0, GeometricTerm::full).v, six(Vector3d::Zero(), (kFree - Vector3d(1, 0, 0)) / kHalf),
                 1e-11,
                 "v after a step of 0.5 s without forces, from (1, 0, 0) m at (1, 2, 0) m/s, length 1 m",
                 "ten times the tolerance of lengths", moving().v);
}

TEST(SecondSolve, TakesTheFiveStepsOnASpring) {
  expect_entries(after(kStiffness, GeometricTerm::dropped).v, six(Vector3d::Zero(), five_steps().v), 1e-9,
                 "v after a step of 0.5 s from (1, 0, 0) m at (1, 2, 0) m/s, 2 kg, a spring of 8 N/m and 1 m",
                 "1e-10 of the solves, ten times");
}

TEST(Cost, EvaluatesTheForceTwice) {
  look_at("force");
  const Spring spring(kStiffness, 1, GeometricTerm::dropped);
  State state = moving();
  step(spring, kHalf, state);
  EXPECT_COUNT(spring.forces, 2) << "evaluations of the force in a step";
}

TEST(Cost, ReportsEachPart) {
  const Spring spring(kStiffness, 1, GeometricTerm::dropped);
  State state = moving();
  const StepReport report = step(spring, kHalf, state);
  EXPECT_TRUE(report.filter.converged) << "the first solve's report of a step that is easy";
  EXPECT_TRUE(report.correction.converged) << "the correction's";
  EXPECT_TRUE(report.second_filter.converged) << "the second solve's";
  EXPECT_GT(report.correction.iterations, 0) << "iterations of the correction";
  // h/2 (f + h df/dx v): at first the spring is at rest length and stretched at 1 m/s. So 0.25 * 8 * 0.5 N s.
  EXPECT_NUMBER(report.filter.rhs, 1, 1e-12) << "the first report's ||right-hand side||";
  EXPECT_GT(std::abs(report.second_filter.rhs - 1), 0.1)
      << "the second report's: is it that of the first solve?";
}

// With springs that know their band, solve_implicit has a preconditioner, whose memory is another part of `scratch`.
TEST(SecondSolve, IsTheSameWithAPreconditioner) {
  look_at("scratch");
  Chain chain(1e-3, 8);
  for (int i = 2; i < 8; ++i) chain.springs.push_back({i - 2, i, 1e-3, 0.02});
  chain.state.x.tail(21) += 1e-3 * scattered_vector(21, 2);
  Strand strand;
  strand.mass = chain.particles.mass;
  strand.rest_length = VectorXd::Constant(7, 0.01);
  const auto after = [&](const particles::Force& force) {
    State state = chain.state;
    state.v = 0.1 * scattered_vector(24, 3);
    MatrixXd scratch = MatrixXd::Constant(24, hair::kPredictorCorrectorScratch, 1e3);
    const StepReport report =
        predictor_corrector(force, chain.particles, strand, kTick, 1e-10, state, scratch);
    for (const particles::SolveReport& solve : {report.filter, report.second_filter}) {
      EXPECT_TRUE(solve.converged);
      if (solve.preconditioned) {
        EXPECT_LE(solve.steps, 2 * particles::kMostSolves)
            << "iterations: the preconditioner is the matrix. Does another number stand in solve_implicit's "
               "`scratch`?";
      }
    }
    return state;
  };
  const State plain = after(particles::DampedSprings(chain.springs, particles::Products::definite)),
              preconditioned = after(BandedSprings(chain.springs, 2));
  const char* const source =
      "the solves' 1e-10, which the correction makes a thousand times as large at most";
  EXPECT_GT(plain.v.norm(), 0.1);
  expect_entries(preconditioned.v, plain.v, 1e-7,
                 "v of 8 particles in a row, springs of 1e-3 N/m that know their band, "
                 "beside v with springs that do not",
                 source);
  expect_entries(preconditioned.x, plain.x, 1e-7 * kTick, "x of the same", source);
}

TEST(Lengths, MovesAStrandOfOneParticleWithItsRoot) {
  look_at("root");
  Strand strand;
  strand.mass = VectorXd::Ones(1);
  State state{VectorXd::Zero(3), Vector3d(1, 2, 3)};
  MatrixXd scratch = MatrixXd::Constant(3, hair::kPredictorCorrectorScratch, 1e3);
  predictor_corrector(particles::DampedSprings({}), {strand.mass, {1}}, strand, 0.5, 1e-10, state, scratch);
  expect_entries(state.x, Vector3d(0.5, 1, 1.5), 0, "x after 0.5 s of a root alone, at (1, 2, 3) m/s", "0");
}

// The tolerance is that of the solves; step 3 has kLengthTolerance.
TEST(OtherLimits, SolvesAsExactlyAsItIsAskedToAndKeepsItsLengths) {
  Chain chain(0.1, 12);
  Strand strand;
  strand.mass = chain.particles.mass;
  strand.rest_length = VectorXd::Constant(11, 0.01);
  int steps[2];
  for (const double tolerance : {1e-10, 1e-2}) {
    State state = chain.state;
    state.v = 0.1 * scattered_vector(36, 3);
    MatrixXd scratch = MatrixXd::Constant(36, hair::kPredictorCorrectorScratch, 1e3);
    const StepReport report =
        predictor_corrector(particles::DampedSprings(chain.springs, particles::Products::definite),
                            chain.particles, strand, kTick, tolerance, state, scratch);
    steps[tolerance > 1e-5] = report.filter.steps;
    for (int i = 0; i < 11; ++i)
      EXPECT_NUMBER((state.x.segment<3>(3 * i + 3) - state.x.segment<3>(3 * i)).norm() / 0.01, 1, 1e-10)
          << "length " << i << " over its rest length, after solves to " << tolerance
          << ": the correction has its own tolerance, kLengthTolerance";
  }
  EXPECT_LT(steps[1], steps[0])
      << "steps of a solve to 1e-2, and to 1e-10: `tolerance` is the solves' tolerance";
}

TEST(OtherLimits, GivesTheImpulseHoweverTheCorrectionEnded) {
  look_at("unconverged");
  // Without forces the way of a particle over h is its velocity, whatever the correction did. A root that is 1e12 m
  // away leaves a correction that never converges; a strand that is flung about takes it many iterations.
  for (const double root : {0.0, 1e12}) {
    Chain chain(0, 12);
    Strand strand;
    strand.mass = chain.particles.mass;
    strand.rest_length = VectorXd::Constant(11, 0.01);
    State state = chain.state;
    state.v = 0.2 / kTick * scattered_vector(36, 3);
    state.v.head<3>() = Vector3d(root / kTick, 0, 0);
    VectorXd alone = state.x + kTick * state.v;
    MatrixXd scratch = MatrixXd::Constant(36, hair::kPredictorCorrectorScratch, 1e3);
    const hair::CorrectionReport expected =
        correct_lengths(strand, hair::kLengthTolerance, hair::kMostCorrections, alone, scratch);
    const StepReport report = predictor_corrector(particles::DampedSprings({}), chain.particles, strand,
                                                  kTick, 1e-10, state, scratch);
    const std::string input = root > 0 ? "a root that moves by 1e12 m" : "12 particles that are flung about";
    EXPECT_EQ(report.correction.converged, expected.converged)
        << input << ": correct_lengths with kLengthTolerance and kMostCorrections took "
        << expected.iterations << " iterations, and yours in the step took " << report.correction.iterations;
    expect_entries(state.v, (state.x - chain.state.x) / kTick,
                   0x1p-48 * (state.x.norm() / kTick + state.v.norm()),
                   "v after " + input + " without forces, beside the way over h", "rounding of x / h");
  }
}

TEST(Units, IsTheSameInEveryUnit) {
  const auto in_unit = [](double unit) {
    Strand strand = two();
    strand.rest_length *= unit;
    const Spring spring(8, unit, GeometricTerm::dropped);
    State state = moving();
    state.x *= unit;
    state.v *= unit;
    MatrixXd scratch = MatrixXd::Constant(6, hair::kPredictorCorrectorScratch, 1e3);
    predictor_corrector(spring, kTwo, strand, 0.5, 1e-10, state, scratch);
    return State{state.x / unit, state.v / unit};
  };
  const State known = in_unit(1);
  for (const double unit : {0x1p-50, 0x1p20}) {
    const State same = in_unit(unit);
    const std::string what = " after a step where all lengths are " + ::testing::PrintToString(unit) +
                             " times as large, over that number";
    const char* const source = "powers of two don't round. What is compared with a number that has a unit?";
    expect_entries(same.x, known.x, 1e-12, "x" + what, source);
    expect_entries(same.v, known.v, 1e-12, "v" + what, source);
  }
}

TEST(SecondSolve, TakesTheSameStepHoweverOftenItIsAsked) {
  look_at("static");
  const Spring spring(8, 1, GeometricTerm::dropped);
  State first = moving();
  step(spring, 0.5, first);
  for (int i = 1; i <= kManyCalls; ++i) {
    State again = moving();
    step(spring, 0.5, again);
    ASSERT_EQ(again.x, first.x) << "x after the same step, asked again, " << i << " times so far";
    ASSERT_EQ(again.v, first.v) << "v after the same step, asked again, " << i << " times so far";
  }
}

TEST(Lengths, LeavesTheRootItsVelocity) {
  look_at("root");
  const Spring spring(8, 1, GeometricTerm::dropped);
  State state = moving();
  state.v[1] = 0.25;
  step(spring, 0.5, state);
  expect_entries(state.v.head<3>(), Vector3d(0, 0.25, 0), 0, "the velocity of a root that moves",
                 "nothing acts on it");
  expect_entries(state.x.head<3>(), Vector3d(0, 0.125, 0), 4 * kU, "the position of a root that moves",
                 "rounding");
}

TEST(SecondSolve, AMassThatTurnsOnAStiffSpring) {
  const auto turn = [](const particles::Force& force, const Particles& particles, double h, State& state) {
    Strand strand;
    strand.mass = particles.mass;
    strand.rest_length = VectorXd::Constant(1, 0.3);
    MatrixXd scratch(6, hair::kPredictorCorrectorScratch);
    predictor_corrector(force, particles, strand, h, particles::kSolveTolerance, state, scratch);
  };
  std::printf("One revolution, h = 1/60 s, k/m = 1e8 / s^2: your row of the table in the assignment\n");
  const Revolution after = revolve("predictor-corrector", GeometricTerm::filtered, turn);
  const double h = 1.0 / 60, omega = 2 * std::numbers::pi;
  EXPECT_NUMBER(after.momentum, 1 / std::sqrt(1 + omega * omega * h), 1e-4)
      << "L/L0: 1/sqrt(1 + Omega^2 h t)";
  EXPECT_LE(after.length, 1e-12) << "the largest error of the length";
  EXPECT_LE(after.radial, 2e-5) << "the largest velocity along the spring, m/s: step 5 filters it out";
}

int main(int argc, char** argv) {
  return run(argc, argv, {{"predictor_corrector", [] {
                             const Spring none(0, 1, GeometricTerm::full);
                             State state = moving();
                             step(none, 0.5, state);
                           }}});
}
