// The public checks of P1. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in particles/explicit_integrators.h.
//
// All four methods go through the same checks: ForwardEuler/Integrator.HasItsOrder/0,
// Each/EitherSign.GoesBackInTime/midpoint.

#include "particles/explicit_integrators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "check.h"
#include "derivative.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/springs.h"
#include "particles/system.h"

using namespace checks;
using namespace particles;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

const double kUnit = std::ldexp(1.0, -53), kNaN = std::numeric_limits<double>::quiet_NaN();

// x and v after one step of Pendulums by each method, computed with 40 digits.
const VectorXd kForwardSwing =
    vector({1.38, -1.06, -0.43, -0.0849960443472, 1.36317994025797, -2.55926001743090});
const VectorXd kSymplecticSwing = vector({0.666001582261106, -0.754728023896811, -0.573704006972358,
                                          -0.0849960443472, 1.36317994025797, -2.55926001743090});
const VectorXd kMidpointSwing = vector({1.02300079113055, -0.907364011948406, -0.501852003486179,
                                        -0.0883242449451, 1.19084921921781, -1.32962660103826});
const VectorXd kRungeKuttaSwing = vector({1.03869634646483, -0.925683137435116, -0.355821898794791,
                                          0.0390354892976, 1.22449406747721, -1.57326780495699});

struct Method {
  const char* name;
  int order, evaluations;
  void (*step)(Dynamics&, double, Output, Output, Scratch);
  const VectorXd& swing;
  double x, v;  // one step of h = 0.5 from x = 1, v = 2 with a = -4x - v, by hand
};

const Method kForwardEuler = {"forward_euler", 1, 1, forward_euler, kForwardSwing, 2, -1};
const Method kSymplecticEuler = {"symplectic_euler", 1, 1, symplectic_euler, kSymplecticSwing, 0.5, -1};
const Method kMidpoint = {"midpoint", 2, 2, midpoint, kMidpointSwing, 1.25, -1.25};
const Method kRungeKutta4 = {"runge_kutta_4", 4, 4, runge_kutta_4, kRungeKuttaSwing, 1 + 3.3125 / 12,
                             2 - 33.0625 / 12};

// With this a failure names forward_euler, instead of printing a pointer.
void PrintTo(const Method& method, std::ostream* out) {
  *out << method.name;
}

bool overlap(Input in, Input out) {
  return in.data() < out.data() + out.size() && out.data() < in.data() + in.size();
}

// a = -k x - c v, and a count of its evaluations.
class Spring1 : public Dynamics {
 public:
  explicit Spring1(double k, double c = 0) : k_(k), c_(c) {}

  void acceleration(Input x, Input v, Output a) override {
    ++evaluations;
    EXPECT_FALSE(overlap(x, a) || overlap(v, a)) << "acceleration() is given memory for a that holds x or v, "
                                                    "too: it may write a before it has read them";
    a = -k_ * x - c_ * v;
  }

  int evaluations = 0;

 private:
  double k_, c_;
};

// Three pendulums and the air's drag, which couples them: a depends on x and v, and is linear in neither. So
// methods of the same order differ.
class Pendulums : public Dynamics {
 public:
  void acceleration(Input x, Input v, Output a) override {
    const Eigen::Array3d strength(4.3, 2.6, 7.1);
    a = -strength * x.array().sin() - 0.35 * v.norm() * v.array();
  }
};

MatrixXd scratch_for(const VectorXd& x, double junk = kNaN) {
  return MatrixXd::Constant(x.size(), kIntegratorScratch, junk);
}

void steps(const Method& method, Dynamics& dynamics, double h, int count, State& state) {
  MatrixXd scratch = scratch_for(state.x);
  for (int i = 0; i < count; ++i) method.step(dynamics, h, state.x, state.v, scratch);
}

class Integrator : public testing::TestWithParam<Method> {};
// These run after all of Integrator.
class Oscillator : public Integrator {};
class Spiral : public Integrator {};
// These run for each method.
class Evaluations : public Integrator {};
class EitherSign : public Integrator {};
class ScratchMemory : public Integrator {};
class SizesAndUnits : public Integrator {};
class BlowUp : public Integrator {};

// The error of (x, v / omega) of an oscillator at omega t = 2.
double oscillator_error(const Method& method, int count) {
  const double omega = 3;
  Spring1 spring(omega * omega);
  State state{VectorXd::Constant(3, 0.7), VectorXd::Constant(3, -1.1)};
  const double x = 0.7 * std::cos(2) - 1.1 / omega * std::sin(2);
  const double v = -1.1 * std::cos(2) - 0.7 * omega * std::sin(2);
  steps(method, spring, 2 / omega / count, count, state);
  return std::hypot(state.x[0] - x, (state.v[0] - v) / omega);
}

}  // namespace

TEST_P(Integrator, TakesOneStepAsByHand) {
  Spring1 spring(4, 1);
  State state{VectorXd::Constant(3, 1), VectorXd::Constant(3, 2)};
  steps(GetParam(), spring, 0.5, 1, state);
  SCOPED_TRACE("one step of h = 0.5 from x = 1, v = 2 with a = -4x - v: see step 1 of the text");
  const std::string source = "16 roundings of numbers that are at most 8";
  expect_entries(state.x, VectorXd::Constant(3, GetParam().x), 16 * 8 * kUnit, "x", source);
  expect_entries(state.v, VectorXd::Constant(3, GetParam().v), 16 * 8 * kUnit, "v", source);
}

TEST_P(Integrator, TakesOneStepWhereNothingIsLinear) {
  Pendulums pendulums;
  State state{Vector3d(0.7, -1.3, 0.45), Vector3d(1.7, 0.6, -2.2)};
  steps(GetParam(), pendulums, 0.4, 1, state);
  SCOPED_TRACE(
      "one step of h = 0.4 from x = (0.7, -1.3, 0.45), v = (1.7, 0.6, -2.2) with "
      "a = -(4.3, 2.6, 7.1) sin x - 0.35 |v| v, entry by entry");
  const std::string source = "rounding of the numbers that are written here";
  expect_entries(state.x, GetParam().swing.head(3), 1e-13, "x", source);
  expect_entries(state.v, GetParam().swing.tail(3), 1e-13, "v", source);
}

TEST_P(Integrator, HasItsOrder) {
  const double coarse = oscillator_error(GetParam(), 64), fine = oscillator_error(GetParam(), 128);
  const double order = std::log2(coarse / fine);
  EXPECT_NUMBER(order, GetParam().order, 0.1)
      << "an oscillator of omega = 3 at omega t = 2: the error is " << coarse << " after 64 steps and "
      << fine
      << " after 128; bound: twice as many steps make it 2^order times "
         "as small, up to a factor of 1 + h omega";
}

TEST_P(Evaluations, CostsItsNumberOfEvaluations) {
  Spring1 spring(1);
  State state{VectorXd::Constant(6, 1), VectorXd::Constant(6, 2)};
  steps(GetParam(), spring, 0.1, 3, state);
  EXPECT_COUNT(spring.evaluations, 3 * GetParam().evaluations) << "evaluations of a in 3 steps";
}

TEST_P(EitherSign, GoesBackInTime) {
  // With a(x) alone a step of -h is a step of h with the velocities turned around.
  Spring1 spring(2);
  const VectorXd x = scattered_vector(6, 1), v = scattered_vector(6, 2);
  State back{x, v}, forth{x, -v};
  steps(GetParam(), spring, -0.1, 1, back);
  steps(GetParam(), spring, 0.1, 1, forth);
  const std::string source = "16 roundings of numbers that are about 1";
  SCOPED_TRACE("h = -0.1 from x = " + particles_in_words(x) + ", v = " + particles_in_words(v));
  expect_entries(back.x, forth.x, 16 * kUnit, "x", source);
  expect_entries(back.v, -forth.v, 16 * kUnit, "v", source);
}

TEST_P(EitherSign, DoesNothingInNoTime) {
  Spring1 spring(2, 1);
  const VectorXd x = scattered_vector(6, 1), v = scattered_vector(6, 2);
  State state{x, v};
  steps(GetParam(), spring, 0, 1, state);
  EXPECT_EQ(state.x, x) << "h = 0";
  EXPECT_EQ(state.v, v) << "h = 0";
}

TEST_P(ScratchMemory, NeverReadsWhatScratchHeld) {
  Spring1 spring(2, 1);
  State first{scattered_vector(6, 1), scattered_vector(6, 2)}, second = first;
  MatrixXd zeros = scratch_for(first.x, 0), junk = scratch_for(first.x, kNaN);
  GetParam().step(spring, 0.1, first.x, first.v, zeros);
  GetParam().step(spring, 0.1, second.x, second.v, junk);
  EXPECT_EQ(first.x, second.x) << "x with zeros in scratch, and with NaN";
  EXPECT_EQ(first.v, second.v) << "v with zeros in scratch, and with NaN";
}

TEST_P(ScratchMemory, TakesTheSameStepHoweverOftenItIsAsked) {
  Pendulums pendulums;
  const State start{scattered_vector(3, 1), scattered_vector(3, 2)};
  State first = start;
  steps(GetParam(), pendulums, 0.1, 1, first);
  for (int i = 1; i <= kManyCalls; ++i) {
    State again = start;
    steps(GetParam(), pendulums, 0.1, 1, again);
    ASSERT_EQ(again.x, first.x) << "x after the same step, asked again, " << i << " times so far";
    ASSERT_EQ(again.v, first.v) << "v after the same step, asked again, " << i << " times so far";
  }
}

TEST_P(SizesAndUnits, MovesEveryParticle) {
  for (int n : {0, 1, 2, 100}) {
    SCOPED_TRACE(std::to_string(n) + " particles that are alike");
    Spring1 spring(2, 1);
    State state{VectorXd::Constant(3 * n, 1), VectorXd::Constant(3 * n, 2)};
    steps(GetParam(), spring, 0.1, 1, state);
    if (n == 0) continue;
    EXPECT_NE(state.x[0], 1);
    EXPECT_EQ(state.x, VectorXd::Constant(3 * n, state.x[0]));
    EXPECT_EQ(state.v, VectorXd::Constant(3 * n, state.v[0]));
  }
}

TEST_P(SizesAndUnits, HasNoUnitOfItsOwn) {
  // a = -4 x - v has no unit of length, and powers of two change no digit.
  Spring1 spring(4, 1);
  State metres{scattered_vector(6, 1), scattered_vector(6, 2)};
  for (int power : {-90, 90}) {
    SCOPED_TRACE(std::string(GetParam().name) + " with x and v times 2^" + std::to_string(power));
    const double unit = std::ldexp(1.0, power);
    State plain = metres, scaled{unit * metres.x, unit * metres.v};
    steps(GetParam(), spring, 0.25, 3, plain);
    steps(GetParam(), spring, 0.25, 3, scaled);
    EXPECT_EQ(scaled.x, unit * plain.x);
    EXPECT_EQ(scaled.v, unit * plain.v);
  }
}

TEST_P(Integrator, LeavesPinnedParticlesTheirVelocity) {
  // Two particles on a spring under gravity: one is pinned, and pulled along at 3 m/s.
  const Particles pair{Eigen::Vector2d(0.2, 0.5), {1, 0}};
  ForceSum force;
  force.emplace<Gravity>(pair.mass, Vector3d(0, 0, -9.81));
  force.emplace<DampedSprings>(std::vector<Spring>{{0, 1, 5, 1}});
  ParticleSystem system(pair, force);
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[5] = -1.2;
  state.v[0] = 3;
  steps(GetParam(), system, 0.1, 10, state);
  EXPECT_EQ(Vector3d(state.v.head<3>()), Vector3d(3, 0, 0));
  expect_entries(state.x.head<3>(), Vector3d(3, 0, 0), 100 * 3 * kUnit, "x after 10 steps of 0.1 s at 3 m/s",
                 "10 roundings a step");
}

TEST_P(BlowUp, ReturnsWhenNumbersOverflow) {
  Spring1 spring(1e12);
  State state{VectorXd::Constant(3, 1), VectorXd::Constant(3, 0)};
  steps(GetParam(), spring, 1, 60, state);
  EXPECT_FALSE(state.x.allFinite() && state.v.allFinite())
      << "an oscillator with h omega = 1e6 grows at least by 1e6 a step: after 60 no number can hold it; x = "
      << particles_in_words(state.x);
}

INSTANTIATE_TEST_SUITE_P(ForwardEuler, Integrator, testing::Values(kForwardEuler));
INSTANTIATE_TEST_SUITE_P(SymplecticEuler, Integrator, testing::Values(kSymplecticEuler));
INSTANTIATE_TEST_SUITE_P(Midpoint, Integrator, testing::Values(kMidpoint));
INSTANTIATE_TEST_SUITE_P(RungeKutta4, Integrator, testing::Values(kRungeKutta4));
const auto kMethods = testing::Values(kForwardEuler, kSymplecticEuler, kMidpoint, kRungeKutta4);
const auto kName = [](const testing::TestParamInfo<Method>& method) {
  return std::string(method.param.name);
};
INSTANTIATE_TEST_SUITE_P(Each, Evaluations, kMethods, kName);
INSTANTIATE_TEST_SUITE_P(Each, EitherSign, kMethods, kName);
INSTANTIATE_TEST_SUITE_P(Each, ScratchMemory, kMethods, kName);
INSTANTIATE_TEST_SUITE_P(Each, SizesAndUnits, kMethods, kName);
INSTANTIATE_TEST_SUITE_P(Each, BlowUp, kMethods, kName);

TEST_P(Oscillator, KeepsItsEnergyBounded) {
  // It keeps v^2 + x^2 - h v x for good, here with omega = 1.
  const double h = 0.5;
  Spring1 spring(1);
  State state{VectorXd::Constant(3, 1), VectorXd::Constant(3, 0.3)};
  double least = INFINITY, most = 0;
  for (int i = 0; i < 20000; ++i) {
    steps(GetParam(), spring, h, 1, state);
    const double energy = std::pow(state.x[0], 2) + std::pow(state.v[0], 2);
    ASSERT_TRUE(std::isfinite(energy)) << "after " << i + 1 << " steps";
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  EXPECT_LE(most / least, (1 + h / 2) / (1 - h / 2) + 1e-9)
      << "largest over least energy in 20000 steps of h omega = 0.5; bound: (1 + h omega/2) / (1 - h "
         "omega/2)";
}

INSTANTIATE_TEST_SUITE_P(SymplecticEuler, Oscillator, testing::Values(kSymplecticEuler));

TEST_P(Spiral, GainsEnergyAsTheTextSays) {
  const double h = 0.1;
  Spring1 spring(1);
  State state{VectorXd::Constant(3, 1), VectorXd::Constant(3, 0)};
  steps(GetParam(), spring, h, 100, state);
  const double expected = std::pow(1 + h * h, 100);
  expect_entries(VectorXd::Constant(1, state.x[0] * state.x[0] + state.v[0] * state.v[0]),
                 VectorXd::Constant(1, expected), 1000 * kUnit * expected,
                 "v^2 + x^2 after 100 steps of h omega = 0.1 from 1", "10 roundings a step");
}

INSTANTIATE_TEST_SUITE_P(ForwardEuler, Spiral, testing::Values(kForwardEuler));

int main(int argc, char** argv) {
  static Spring1 spring(1);
  const auto call = [](const Method& method) {
    return [&method] {
      State nothing;
      steps(method, spring, 1, 1, nothing);
    };
  };
  return run(argc, argv,
             {{"forward_euler", call(kForwardEuler)},
              {"symplectic_euler", call(kSymplecticEuler)},
              {"midpoint", call(kMidpoint)},
              {"runge_kutta_4", call(kRungeKutta4)}});
}
