// STAFF ONLY. Chains, pendulums and double pendulums: the reference swings as theory says, and small faults
// are detected.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/measure_mode.h"
#include "hair/lab/validate/pendulum.h"
#include "hair/lab/validate/record.h"
#include "hair/lab/validate/validations.h"

namespace hair {
namespace {

constexpr double kMass = 1e-7;
const ValidationSettings kQuick{true, nullptr};

void expect_all_hold(const Validation& validation) {
  const ValidationResult result = validation.run(kQuick);
  EXPECT_FALSE(result.checks.empty());
  for (const Check& check : result.checks)
    EXPECT_TRUE(check.holds()) << validation.id << ", " << check.shows << ": expected " << check.expected
                               << ", measured " << check.measured << ", off by " << check.error()
                               << ", allowed " << check.tolerance << " (" << check.tolerance_from << ")";
}

TEST(Oscillations, PublishedNumbersAreWhatIsComputed) {
  expect_all_hold(published_numbers());
}

TEST(Oscillations, H6SwingsChainsAsLaguerrePolynomialsSay) {
  expect_all_hold(chain_oscillations(chain_by_h6()));
}

TEST(Oscillations, RodsSwingChainsAsLaguerrePolynomialsSay) {
  expect_all_hold(chain_oscillations(chain_by_rods()));
}

TEST(Oscillations, H6SwingsPendulumsAsEllipticIntegralsSay) {
  expect_all_hold(pendulum_period(chain_by_h6()));
}

TEST(Oscillations, RodsSwingPendulumsAsEllipticIntegralsSay) {
  expect_all_hold(pendulum_period(chain_by_rods()));
}

TEST(Oscillations, H6SwingsDoublePendulumsAsTheirQuadraticEquationSays) {
  expect_all_hold(double_pendulums(chain_by_h6()));
}

TEST(Oscillations, RodsSwingDoublePendulumsAsTheirQuadraticEquationSays) {
  expect_all_hold(double_pendulums(chain_by_rods()));
}

// A wrong method: it swings another chain than the given one.
template <const ChainMethod& (*method)(), void (*change)(HangingChain&)>
std::unique_ptr<MovingChain> start_changed(const HangingChain& chain, const particles::State& state,
                                           double step) {
  HangingChain changed = chain;
  change(changed);
  return method().start(changed, state, step);
}

void halve_the_tip(HangingChain& chain) {
  chain.mass[chain.count() - 1] /= 2;
}

void pull_a_little_more(HangingChain& chain) {
  chain.gravity *= 1 + 1e-5;
}

// The relative errors of the slowest mode of ten masses, over its tolerance.
double error_over_tolerance(const ChainMethod& method) {
  const HangingChain chain{Eigen::VectorXd::Constant(10, kMass)};
  const Eigen::VectorXd zeros = laguerre_zeros(10);
  const MeasuredMode mode = measure_mode(method, chain, zeros[0], zeros[9], kQuick);
  return std::abs(mode.square / zeros[0] - 1) / mode.tolerance;
}

template <const ChainMethod& (*method)(), void (*change)(HangingChain&)>
double error_of_changed() {
  ChainMethod wrong = method();
  wrong.start = start_changed<method, change>;
  return error_over_tolerance(wrong);
}

TEST(Oscillations, HalfTheMassAtTheTipIsFoundOut) {
  EXPECT_LE(error_over_tolerance(chain_by_h6()), 1);
  EXPECT_LE(error_over_tolerance(chain_by_rods()), 1);
  EXPECT_GT((error_of_changed<chain_by_h6, halve_the_tip>()), 1000);
  EXPECT_GT((error_of_changed<chain_by_rods, halve_the_tip>()), 1000);
}

TEST(Oscillations, GravityThatIsOffByAHundredThousandthIsFoundOut) {
  EXPECT_GT((error_of_changed<chain_by_h6, pull_a_little_more>()), 10);
  EXPECT_GT((error_of_changed<chain_by_rods, pull_a_little_more>()), 10);
}

TEST(Oscillations, LinksThatAreTooLongByATenThousandthAreFoundOut) {
  ChainMethod wrong = chain_by_rods();
  wrong.start = [](const HangingChain& chain, const particles::State& state, double step) {
    HangingChain longer = chain;
    longer.link *= 1 + 1e-4;
    particles::State stretched = state;
    stretched.x *= 1 + 1e-4;
    return chain_by_rods().start(longer, stretched, step);
  };
  EXPECT_GT(error_over_tolerance(wrong), 10);
}

TEST(Oscillations, AnotherMethodsDispersionIsFoundOut) {
  ChainMethod wrong = chain_by_rods();
  wrong.undo = undo_leapfrog;
  EXPECT_GT(error_over_tolerance(wrong), 1000);
}

// In each step it loses a ten-millionth of the sideways motion, more than allowed.
class DampedChain : public MovingChain {
 public:
  explicit DampedChain(std::unique_ptr<MovingChain> chain)
      : chain_(std::move(chain)), state_(chain_->state()) {}
  void step() override {
    chain_->step();
    state_ = chain_->state();
    kept_ *= 1 - 1e-7;
    for (Eigen::Index i = 0; i < state_.x.size(); i += 3) state_.x[i] *= kept_;
  }
  const particles::State& state() const override { return state_; }

 private:
  std::unique_ptr<MovingChain> chain_;
  particles::State state_;
  double kept_ = 1;
};

TEST(Oscillations, DampingThatNoFrequencyShowsIsFoundOut) {
  ChainMethod damped = chain_by_rods();
  damped.start = [](const HangingChain& chain, const particles::State& state,
                    double step) -> std::unique_ptr<MovingChain> {
    return std::make_unique<DampedChain>(chain_by_rods().start(chain, state, step));
  };
  EXPECT_LE(error_over_tolerance(damped), 1);
  int found = 0;
  for (const Check& check : chain_oscillations(damped).run(kQuick).checks)
    found += check.id.ends_with("decay") && !check.holds() ? 1 : 0;
  EXPECT_EQ(found, 3) << "of chains of 2, 10 and 20 masses";
}

// A student's method may return NaN, here from the third step on.
class BrokenChain : public MovingChain {
 public:
  explicit BrokenChain(const particles::State& state) : state_(state) {}
  void step() override {
    if (++steps_ == 3) state_.x.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  const particles::State& state() const override { return state_; }

 private:
  particles::State state_;
  int steps_ = 0;
};

TEST(Oscillations, WhatBreaksDoesNotHoldAndIsShown) {
  ChainMethod broken = chain_by_h6();
  broken.start = [](const HangingChain&, const particles::State& state,
                    double) -> std::unique_ptr<MovingChain> { return std::make_unique<BrokenChain>(state); };
  for (const Validation& one :
       {pendulum_period(broken), chain_oscillations(broken), double_pendulums(broken)}) {
    const ValidationRecord record{one.id, one.title, one.exercises, one.run(kQuick)};
    for (const Check& check : record.result.checks)
      EXPECT_FALSE(check.holds()) << one.id << ", " << check.shows;
    EXPECT_NE(to_html(page_of({record})).find(one.id), std::string::npos);
    EXPECT_FALSE(json_of({record}).empty());
    EXPECT_FALSE(check_rows({record}).empty());
  }
}

// One pendulum by the lecture's five steps, written as angles, with the parts of a step during which its
// filters act.
class HalfStepPendulum : public MovingChain {
 public:
  HalfStepPendulum(const HangingChain& chain, const particles::State& state, double step, double first,
                   double second)
      : chain_(chain), h_(step), first_(first), second_(second), state_(state) {
    angle_ = std::atan2(state.x[3], -state.x[5]);
  }

  void step() override {
    const double l = chain_.link;
    const double turn = std::atan((speed_ - first_ * h_ * chain_.gravity * std::sin(angle_)) * h_ / l);
    angle_ += turn;
    speed_ = l * std::sin(turn) / h_ - second_ * h_ * chain_.gravity * std::sin(angle_);
    state_.x.tail<3>() = l * Eigen::Vector3d(std::sin(angle_), 0, -std::cos(angle_));
    state_.v.tail<3>() = speed_ * Eigen::Vector3d(std::cos(angle_), 0, std::sin(angle_));
  }

  const particles::State& state() const override { return state_; }

 private:
  HangingChain chain_;
  double h_, first_, second_, angle_, speed_ = 0;
  particles::State state_;
};

template <int first, int second>
std::unique_ptr<MovingChain> start_halves(const HangingChain& chain, const particles::State& state,
                                          double step) {
  return std::make_unique<HalfStepPendulum>(chain, state, step, first / 4.0, second / 4.0);
}

// These are H6's five steps for one segment that does not stretch: a filter removes the part along the
// segment, the correction turns a step along the tangent into one along the circle, and the impulse makes its
// chord the velocity. So the numbers are the same, except for the springs' stretch (1e-11 in each step) and
// the solves' residuals (1e-12).
TEST(Oscillations, H6IsTheMapThatItsFiveStepsMakeOfAPendulum) {
  ChainMethod map = chain_by_h6();
  map.start = start_halves<2, 2>;
  const double angle = std::numbers::pi / 2;
  EXPECT_NEAR(measured_period_ratio(map, angle, 800, kQuick),
              measured_period_ratio(chain_by_h6(), angle, 800, kQuick), 1e-7);
}

// The map is of order 1. Extrapolated as if it were of order 2, its result keeps an error of order 1, and
// halving the steps changes it by as much as that error, so the change is no measure of the rest.
TEST(Oscillations, ALostOrderIsFoundOutAtEachAngle) {
  ChainMethod map = chain_by_h6();
  map.start = start_halves<2, 2>;
  map.order = 2;
  for (const Check& check : pendulum_period(map).run(kQuick).checks)
    EXPECT_GT(std::abs(check.error()), (check.id == "order" ? 1 : 10) * check.tolerance) << check.id;
}

bool all_hold(const ChainMethod& method) {
  for (const Check& check : pendulum_period(method).run(kQuick).checks)
    if (!check.holds()) return false;
  return true;
}

TEST(Oscillations, AWrongHalfStepIsFoundOut) {
  ChainMethod map = chain_by_h6();
  map.start = start_halves<2, 2>;
  EXPECT_TRUE(all_hold(map));
  map.start = start_halves<2, 1>;
  EXPECT_FALSE(all_hold(map)) << "a second filter of a quarter of a step";
  map.start = start_halves<4, 2>;
  EXPECT_FALSE(all_hold(map)) << "a first filter of a whole step";
}

}  // namespace
}  // namespace hair
