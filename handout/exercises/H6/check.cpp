// The public checks of H6. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in hair/predictor_corrector.h. They need S1, H4 and H5.

#include "hair/predictor_corrector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "check.h"
#include "derivative.h"
#include "implicit_systems.h"

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

VectorXd six(const Vector3d& root, const Vector3d& other) {
  VectorXd values(6);
  values << root, other;
  return values;
}

constexpr double kMass = 2.3, kRest = 0.8;  // kg, m

// A root and a particle, kRest apart at rest.
Strand two() {
  Strand strand;
  strand.mass = Eigen::Vector2d(1.7, kMass);
  strand.rest_length = VectorXd::Constant(1, kRest);
  return strand;
}

const Particles kTwo{two().mass, {1, 0}};

// The particle is at rest length from the root, which is at 0 and rests.
const Vector3d kAlong(0.6, 0.48, 0.64), kSpeed(1.3, 2.1, -0.4);

State moving() {
  return {six(Vector3d::Zero(), kRest * kAlong), six(Vector3d::Zero(), kSpeed)};
}

StepReport step(const particles::Force& force, double h, State& state) {
  MatrixXd scratch = MatrixXd::Constant(6, hair::kPredictorCorrectorScratch, 1e3);
  return predictor_corrector(force, kTwo, two(), h, 1e-10, state, scratch);
}

constexpr double kHalf = 0.5;  // s, the length of the steps below

// h^2 k/m is about 1: every step shows. The spring pulls: it is shorter at rest than the strand.
constexpr double kStiffness = 9, kSpring = 0.65, kRatio = kHalf * kHalf * kStiffness / 2;  // N/m, m, kg
constexpr double kPull = kHalf / 2 * kStiffness * (kRest - kSpring);                       // N s

const char* const kText =
    "after a step of 0.5 s from (0.48, 0.384, 0.512) m at (1.3, 2.1, -0.4) m/s, 2.3 kg, rest length 0.8 m";

// The velocity that a solve makes of v, where the strand has its length along u: (m + ratio) dv = -pull -
// ratio v.
Vector3d filtered(const Vector3d& v, const Vector3d& u) {
  return v - (kPull + kRatio * u.dot(v)) / (kMass + kRatio) * u;
}

struct FiveSteps {
  Vector3d predicted, x, v;

  // Without a spring the solves do nothing.
  explicit FiveSteps(bool spring) {
    const Vector3d v1 = spring ? filtered(kSpeed, kAlong) : kSpeed;
    predicted = kRest * kAlong + kHalf * v1;
    const Vector3d u = predicted.normalized();
    x = kRest * u;
    const Vector3d v2 = v1 + (x - predicted) / kHalf;
    v = spring ? filtered(v2, u) : v2;
  }
};

State after(double stiffness, GeometricTerm term) {
  State state = moving();
  step(Spring(stiffness, kSpring, term), kHalf, state);
  return state;
}

}  // namespace

TEST(Prediction, MovesWithThePredictedVelocity) {
  // The rest length is the length that step 2 leads to: nothing is corrected.
  const Vector3d predicted = FiveSteps(true).predicted;
  Strand strand = two();
  strand.rest_length[0] = predicted.norm();
  State state = moving();
  MatrixXd scratch = MatrixXd::Constant(6, hair::kPredictorCorrectorScratch, 1e3);
  predictor_corrector(Spring(kStiffness, kSpring, GeometricTerm::dropped), kTwo, strand, kHalf, 1e-10, state,
                      scratch);
  expect_entries(
      state.x, six(Vector3d::Zero(), predicted), 1e-9,
      std::string("x with a spring of 9 N/m and 0.65 m, where the length is right after step 2, ") + kText,
      "1e-10 of the solves, ten times", moving().x);
}

TEST(Lengths, WithoutForcesGoesToTheRightLength) {
  expect_entries(after(0, GeometricTerm::full).x, six(Vector3d::Zero(), FiveSteps(false).x), 1e-11,
                 std::string("x without forces ") + kText, "ten times the tolerance of lengths", moving().x);
}

TEST(Prediction, PutsASpringWhereTheFiveStepsDo) {
  expect_entries(after(kStiffness, GeometricTerm::dropped).x, six(Vector3d::Zero(), FiveSteps(true).x), 1e-9,
                 std::string("x with a spring of 9 N/m and 0.65 m ") + kText,
                 "1e-10 of the solves, ten times");
}

TEST(Impulse, WithoutForcesGivesTheImpulse) {
  expect_entries(after(0, GeometricTerm::full).v, six(Vector3d::Zero(), FiveSteps(false).v), 1e-11,
                 std::string("v without forces ") + kText, "ten times the tolerance of lengths", moving().v);
}

TEST(SecondSolve, TakesTheFiveStepsOnASpring) {
  expect_entries(after(kStiffness, GeometricTerm::dropped).v, six(Vector3d::Zero(), FiveSteps(true).v), 1e-9,
                 std::string("v with a spring of 9 N/m and 0.65 m ") + kText,
                 "1e-10 of the solves, ten times");
}

TEST(Cost, EvaluatesTheForceTwice) {
  const Spring spring(kStiffness, kSpring, GeometricTerm::dropped);
  State state = moving();
  step(spring, kHalf, state);
  EXPECT_COUNT(spring.forces, 2) << "evaluations of the force in a step";
}

TEST(Cost, ReportsEachPart) {
  const Spring spring(kStiffness, kSpring, GeometricTerm::dropped);
  State state = moving();
  const StepReport report = step(spring, kHalf, state);
  EXPECT_TRUE(report.filter.converged) << "the first solve's report of a step that is easy";
  EXPECT_TRUE(report.correction.converged) << "the correction's";
  EXPECT_TRUE(report.second_filter.converged) << "the second solve's";
  EXPECT_GT(report.correction.iterations, 0) << "iterations of the correction";
  const double first = kPull + kRatio * kAlong.dot(kSpeed);  // h/2 (f + h df/dx v)
  EXPECT_NUMBER(report.filter.rhs, first, 1e-12) << "the first report's ||right-hand side||";
  EXPECT_GT(std::abs(report.second_filter.rhs - first), 0.1)
      << "the second report's: is it that of the first solve?";
}

// With springs that know their band, solve_implicit has a preconditioner, whose memory is another part of
// `scratch`.
TEST(SecondSolve, IsTheSameWithAPreconditioner) {
  Chain chain(1e-3, 8);
  for (int i = 2; i < 8; ++i) chain.springs.push_back({i - 2, i, 1e-3, 0.02});
  const auto after = [&](const particles::Force& force) {
    State state = chain.state;
    MatrixXd scratch = MatrixXd::Constant(24, hair::kPredictorCorrectorScratch, 1e3);
    const StepReport report =
        predictor_corrector(force, chain.particles, chain.strand, kTick, 1e-10, state, scratch);
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
                 "compared with v with springs that do not",
                 source);
  expect_entries(preconditioned.x, plain.x, 1e-7 * kTick, "x of the same", source);
}

TEST(Lengths, MovesAStrandOfOneParticleWithItsRoot) {
  Strand strand;
  strand.mass = VectorXd::Ones(1);
  State state{VectorXd::Zero(3), Vector3d(1, 2, 3)};
  MatrixXd scratch = MatrixXd::Constant(3, hair::kPredictorCorrectorScratch, 1e3);
  predictor_corrector(particles::DampedSprings({}), {strand.mass, {1}}, strand, 0.5, 1e-10, state, scratch);
  expect_entries(state.x, Vector3d(0.5, 1, 1.5), 0, "x after 0.5 s of a root alone, at (1, 2, 3) m/s", "0");
}

// The solves take the caller's tolerance; step 3 takes kLengthTolerance.
TEST(OtherLimits, SolvesAsExactlyAsItIsAskedToAndKeepsItsLengths) {
  const Chain chain(0.1, 12);
  int steps[2];
  for (const double tolerance : {1e-10, 1e-2}) {
    State state = chain.state;
    MatrixXd scratch = MatrixXd::Constant(36, hair::kPredictorCorrectorScratch, 1e3);
    const StepReport report =
        predictor_corrector(particles::DampedSprings(chain.springs, particles::Products::definite),
                            chain.particles, chain.strand, kTick, tolerance, state, scratch);
    steps[tolerance > 1e-5] = report.filter.steps;
    // Sweeps may need more than kMostCorrections, and then say so.
    for (int i = 0; i < 11 && report.correction.converged; ++i)
      EXPECT_NUMBER(
          (state.x.segment<3>(3 * i + 3) - state.x.segment<3>(3 * i)).norm() / chain.strand.rest_length[i], 1,
          1e-10)
          << "length " << i << " over its rest length, after solves to " << tolerance
          << ": the correction has its own tolerance, kLengthTolerance";
  }
  EXPECT_LT(steps[1], steps[0])
      << "steps of a solve to 1e-2, and to 1e-10: `tolerance` is the solves' tolerance";
}

TEST(OtherLimits, GivesTheImpulseHoweverTheCorrectionEnded) {
  // Without forces a particle's velocity is its way over h, even if the correction does not converge, as with
  // a root that is 1e12 m away. A strand that is flung about takes the correction many iterations.
  for (const double root : {0.0, 1e12}) {
    Chain chain(0, 12);
    State state = chain.state;
    state.v *= 2 / kTick;
    state.v[0] = root / kTick;
    const VectorXd before = state.v;
    VectorXd alone = state.x + kTick * before;
    MatrixXd scratch = MatrixXd::Constant(36, hair::kPredictorCorrectorScratch, 1e3);
    const hair::CorrectionReport expected =
        correct_lengths(chain.strand, hair::kLengthTolerance, hair::kMostCorrections, alone, scratch);
    const StepReport report = predictor_corrector(particles::DampedSprings({}), chain.particles, chain.strand,
                                                  kTick, 1e-10, state, scratch);
    const std::string input = root > 0 ? "a root that moves by 1e12 m" : "12 particles that are flung about";
    EXPECT_EQ(report.correction.converged, expected.converged)
        << input << ": correct_lengths with kLengthTolerance and kMostCorrections took "
        << expected.iterations << " iterations, and yours in the step took " << report.correction.iterations;
    const VectorXd way = (state.x - chain.state.x) / kTick;
    EXPECT_GE((state.v - before).tail(33).norm(), 0.1 * (way - before).tail(33).norm())
        << "how much v changes after " << input
        << " without forces, compared with a tenth of what the way over h asks";
  }
}

TEST(Units, IsTheSameInEveryUnit) {
  const auto in_unit = [](double unit) {
    Strand strand = two();
    strand.rest_length *= unit;
    const Spring spring(kStiffness, kSpring * unit, GeometricTerm::dropped);
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
  const Spring spring(kStiffness, kSpring, GeometricTerm::dropped);
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
  const Spring spring(kStiffness, kSpring, GeometricTerm::dropped);
  State state = moving();
  const Vector3d root(0.3, -0.7, 0.25);
  state.v.head<3>() = root;
  step(spring, kHalf, state);
  expect_entries(state.v.head<3>(), root, 0, "the velocity of a root that moves", "nothing acts on it");
  expect_entries(state.x.head<3>(), kHalf * root, 4 * kU, "the position of a root that moves");
}

TEST(SecondSolve, AMassThatTurnsOnAStiffSpring) {
  const auto turn = [](const particles::Force& force, const Particles& particles, double h, State& state) {
    Strand strand;
    strand.mass = particles.mass;
    strand.rest_length = VectorXd::Constant(1, 0.3);
    MatrixXd scratch(6, hair::kPredictorCorrectorScratch);
    predictor_corrector(force, particles, strand, h, particles::kSolveTolerance, state, scratch);
  };
  std::printf("Your row of the text's table:");
  const Revolution after = revolve("predictor-corrector", GeometricTerm::filtered, turn);
  std::puts("");
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
