// STAFF ONLY. The reference swings, bends and comes to rest as theory says: each validation's checks hold. A
// method or a mass that is a little wrong is found out, and records say so.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/measure_mode.h"
#include "hair/lab/validate/record.h"
#include "hair/lab/validate/validations.h"

namespace hair {
namespace {

using Json = OrderedJson;

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

Check a_check(double measured) {
  return {"one", "a length", "a book", 2, measured, 0.5, "a theorem", "m"};
}

ValidationRecord a_record(double measured) {
  return {"first", "The first", {"S1"}, {{a_check(measured)}}};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Check, HoldsWithinItsTolerance) {
  EXPECT_TRUE(a_check(2.5).holds());
  EXPECT_TRUE(a_check(1.5).holds());
  EXPECT_FALSE(a_check(2.5000001).holds());
  EXPECT_FALSE(a_check(1.4999999).holds());
}

TEST(Check, NothingHoldsForWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double none : {nan, infinity, -infinity}) {
    EXPECT_FALSE(a_check(none).holds());
    Check check = a_check(2);
    check.tolerance = nan;
    EXPECT_FALSE(check.holds());
    check = a_check(none);
    check.tolerance = infinity;
    EXPECT_FALSE(check.holds());
  }
}

TEST(ValidationRecord, HoldsIfItRanToItsEndAndAllChecksHold) {
  EXPECT_TRUE(a_record(2).holds());
  EXPECT_FALSE(a_record(3).holds());
  ValidationRecord record = a_record(2);
  record.broke = "it threw";
  EXPECT_FALSE(record.holds());
  record = a_record(2);
  record.left_out = "S1: student/conj_grad.cpp";
  EXPECT_FALSE(record.holds());
}

TEST(ValidationRecord, SaysOnTheTerminalWhatDoesNotHold) {
  EXPECT_TRUE(has(terminal_text(a_record(2)), " ok\n"));
  EXPECT_FALSE(has(terminal_text(a_record(2)), "DOES NOT HOLD"));
  EXPECT_TRUE(has(terminal_text(a_record(3)), "a length, m"));
  EXPECT_TRUE(has(terminal_text(a_record(3)), "DOES NOT HOLD"));
  EXPECT_EQ(summary({a_record(2), a_record(3)}), "1 of 2 checks hold");
}

TEST(ValidationRecord, IsOnThePageWithSourcesAndTolerances) {
  const std::string page = to_html(page_of({a_record(3)}));
  for (const char* part : {"The first", "a length, m", "a book", "a theorem", "NO", "0 of 1 checks hold"})
    EXPECT_TRUE(has(page, part)) << part;
}

TEST(ValidationRecord, AFigureThatCannotBeDrawnDoesNotCostThePage) {
  ValidationRecord record = a_record(3);
  Figure figure;
  figure.id = "broken";
  figure.series = {{"nothing", {{1, std::numeric_limits<double>::quiet_NaN()}}}};
  record.result.figures = {figure};
  const std::string page = to_html(page_of({record}));
  EXPECT_TRUE(has(page, "a theorem"));
  EXPECT_TRUE(has(page, "A figure can")) << page;
}

std::vector<ValidationRecord> of_each_kind() {
  ValidationRecord left_out{"second", "The second", {"H2"}, {}}, broke{"third", "The third", {"H1"}, {}};
  left_out.left_out = "H2: student/angular_springs.cpp";
  broke.broke = "it threw";
  return {a_record(2), left_out, broke};
}

TEST(ValidationRecord, WhatBrokeOrIsLeftOutIsInAllThatIsWritten) {
  EXPECT_EQ(summary(of_each_kind()),
            "1 of 1 checks hold; 1 of 3 validations broke; 1 of 3 validations are left out");
  const std::string csv = csv_of(check_rows(of_each_kind()));
  EXPECT_TRUE(has(csv, "second,,,,left out: it needs H2: student/angular_springs.cpp,,,,,\n")) << csv;
  EXPECT_TRUE(has(csv, "third,,,,broke: it threw,,,,,NO\n")) << csv;
  const Json json = json_of(of_each_kind())["validations"];
  EXPECT_EQ(json[0]["holds"], true);
  EXPECT_EQ(json[0]["checks"][0]["tolerance_from"], "a theorem");
  EXPECT_TRUE(json[1]["holds"].is_null());
  EXPECT_EQ(json[1]["left_out"], "H2: student/angular_springs.cpp");
  EXPECT_EQ(json[2]["holds"], false);
  EXPECT_EQ(json[2]["broke"], "it threw");
}

}  // namespace
}  // namespace hair
