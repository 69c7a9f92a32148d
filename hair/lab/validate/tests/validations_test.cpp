// STAFF ONLY. The reference swings, bends and comes to rest as theory says: each validation's checks hold.
// And a method or a mass that is a little wrong is found out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/measure_mode.h"
#include "hair/lab/validate/record.h"
#include "hair/lab/validate/validations.h"

namespace hair {
namespace {

constexpr double kMass = 1e-7;
const ValidationSettings kQuick{true, nullptr};

class Validations : public testing::TestWithParam<Validation> {};

TEST_P(Validations, Hold) {
  const ValidationResult result = GetParam().run(kQuick);
  EXPECT_FALSE(result.checks.empty());
  for (const Check& check : result.checks)
    EXPECT_TRUE(check.holds()) << check.shows << ": expected " << check.expected << ", measured "
                               << check.measured << ", off by " << check.error() << ", allowed "
                               << check.tolerance << " (" << check.tolerance_from << ")";
}

INSTANTIATE_TEST_SUITE_P(All, Validations, testing::ValuesIn(all_validations({})), [](const auto& test) {
  std::string name = test.param.id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// --- Wrong models ---

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

TEST(Oscillations, ATipTooLightOrALittleMoreGravityOrAnotherDispersionIsFoundOut) {
  EXPECT_LE(error_over_tolerance(chain_by_h6()), 1);
  EXPECT_LE(error_over_tolerance(chain_by_rods()), 1);
  EXPECT_GT((error_of_changed<chain_by_h6, halve_the_tip>()), 1000);
  EXPECT_GT((error_of_changed<chain_by_rods, halve_the_tip>()), 1000);
  EXPECT_GT((error_of_changed<chain_by_h6, pull_a_little_more>()), 10);
  EXPECT_GT((error_of_changed<chain_by_rods, pull_a_little_more>()), 10);
  ChainMethod wrong = chain_by_rods();
  wrong.undo = undo_leapfrog;
  EXPECT_GT(error_over_tolerance(wrong), 1000);
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
  for (const Validation& one : {pendulum_period(broken), chain_oscillations(broken)}) {
    const ValidationRecord record{one.id, one.title, one.exercises, one.run(kQuick)};
    for (const Check& check : record.result.checks)
      EXPECT_FALSE(check.holds()) << one.id << ", " << check.shows;
    EXPECT_NE(to_html(page_of({record})).find(one.id), std::string::npos);
    EXPECT_FALSE(json_of({record}).empty());
    EXPECT_FALSE(check_rows({record}).empty());
  }
}

Eigen::VectorXd cosines(int count) {
  Eigen::VectorXd samples(count);
  for (int k = 0; k < count; ++k) samples[k] = std::cos(0.1 * k);
  return samples;
}

TEST(Sinusoid, WhatIsNoneHasNoFrequency) {
  Eigen::VectorXd samples = cosines(200);
  EXPECT_TRUE(std::isnan(fit_sinusoid(Eigen::VectorXd::Ones(50)).frequency));
  EXPECT_TRUE(std::isnan(fit_sinusoid(Eigen::VectorXd::Zero(50)).frequency));
  EXPECT_TRUE(std::isnan(fit_sinusoid(samples.head(40)).frequency)) << "it changes its sign once";
  EXPECT_TRUE(std::isnan(fit_sinusoid({}).frequency));
  samples[20] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(fit_sinusoid(samples).frequency));
}

}  // namespace
}  // namespace hair
