// STAFF ONLY. The reference swings, bends and comes to rest as theory says: each validation's checks hold. A
// method or a mass that is a little wrong is found out, and records say so.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/record.h"
#include "hair/lab/validate/validations.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

using tests::says;

constexpr double kMass = 1e-7;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
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
  std::ranges::replace(name, '-', '_');
  return name;
});

// --- Wrong models ---

// A wrong method: it swings another chain than the given one.
template <const ChainMethod& (*method)(), void (*change)(HangingChain&)>
Scene changed_scene(const HangingChain& chain, const particles::State& state, double step) {
  HangingChain changed = chain;
  change(changed);
  return method().scene(changed, state, step);
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
  wrong.scene = changed_scene<method, change>;
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

// A chain that falls so fast breaks in its first steps.
TEST(Oscillations, WhatBreaksDoesNotHoldAndIsShown) {
  ChainMethod broken = chain_by_h6();
  broken.scene = [](const HangingChain& chain, const particles::State& state, double step) {
    Scene scene = chain_by_h6().scene(chain, state, step);
    scene.hair.gravity *= 1e300;
    return scene;
  };
  for (const Validation& one : {pendulum_period(broken), chain_oscillations(broken)}) {
    const ValidationRecord record{one.id, one.title, one.exercises, one.run(kQuick)};
    for (const Check& check : record.result.checks)
      EXPECT_FALSE(check.holds()) << one.id << ", " << check.shows;
    EXPECT_TRUE(says(to_html(page_of({record})), one.id));
    EXPECT_FALSE(json_of({record}).empty());
    EXPECT_FALSE(check_rows({record}).empty());
  }
}

TEST(Sinusoid, WhatIsNoneHasNoFrequency) {
  Eigen::VectorXd samples(200);
  for (int k = 0; k < samples.size(); ++k) samples[k] = std::cos(0.1 * k);
  EXPECT_TRUE(std::isnan(fit_sinusoid(samples.head(40)).frequency)) << "it changes its sign once";
  samples[20] = kNaN;
  for (const Eigen::VectorXd& none : {Eigen::VectorXd(), Eigen::VectorXd(Eigen::VectorXd::Ones(50)),
                                      Eigen::VectorXd(Eigen::VectorXd::Zero(50)), samples})
    EXPECT_TRUE(std::isnan(fit_sinusoid(none).frequency)) << none.transpose();
}

Check a_check(double measured, double tolerance = 0.5) {
  return {"one", "a length", "a book", 2, measured, tolerance, "a theorem", "m"};
}

TEST(Check, HoldsWithinItsToleranceAndNeverForWhatIsNoNumber) {
  for (const double measured : {1.5, 2.5}) EXPECT_TRUE(a_check(measured).holds());
  for (const double measured : {1.4999999, 2.5000001, kNaN, kInfinity, -kInfinity})
    EXPECT_FALSE(a_check(measured).holds()) << measured;
  for (const double measured : {kNaN, kInfinity, -kInfinity})
    EXPECT_FALSE(a_check(measured, kInfinity).holds()) << measured;
  EXPECT_FALSE(a_check(2, kNaN).holds());
}

ValidationRecord a_record(double measured, const std::string& left_out = "", const std::string& broke = "") {
  return {"first", "The first", {"S1"}, {{a_check(measured)}}, left_out, broke};
}

TEST(ValidationRecord, HoldsIfItRanToItsEndAndAllChecksHold) {
  EXPECT_TRUE(a_record(2).holds());
  EXPECT_FALSE(a_record(3).holds());
  EXPECT_FALSE(a_record(2, "S1: student/conj_grad.cpp").holds());
  EXPECT_FALSE(a_record(2, "", "it threw").holds());
}

// A figure that can't be drawn does not cost the page.
TEST(ValidationRecord, SaysOnTheTerminalAndOnThePageWhatDoesNotHold) {
  EXPECT_TRUE(says(terminal_text(a_record(2)), " ok\n"));
  EXPECT_FALSE(says(terminal_text(a_record(2)), "DOES NOT HOLD"));
  ValidationRecord record = a_record(3);
  EXPECT_TRUE(says(terminal_text(record), "a length, m"));
  EXPECT_TRUE(says(terminal_text(record), "DOES NOT HOLD"));
  EXPECT_EQ(summary({a_record(2), record}), "1 of 2 checks hold");
  Figure& figure = record.result.figures.emplace_back();
  figure.id = "broken";
  figure.series = {{"nothing", {{1, kNaN}}}};
  const std::string page = to_html(page_of({record}));
  for (const char* part :
       {"The first", "a length, m", "a book", "a theorem", "NO", "0 of 1 checks hold", "A figure can"})
    EXPECT_TRUE(says(page, part));
}

TEST(ValidationRecord, WhatBrokeOrIsLeftOutIsInAllThatIsWritten) {
  const std::vector<ValidationRecord> records = {
      a_record(2),
      {"second", "The second", {"H2"}, {}, "H2: student/angular_springs.cpp"},
      {"third", "The third", {"H1"}, {}, "", "it threw"}};
  EXPECT_EQ(summary(records),
            "1 of 1 checks hold; 1 of 3 validations broke; 1 of 3 validations are left out");
  const std::string csv = csv_of(check_rows(records));
  EXPECT_TRUE(says(csv, "second,,,,left out: it needs H2: student/angular_springs.cpp,,,,,\n"));
  EXPECT_TRUE(says(csv, "third,,,,broke: it threw,,,,,NO\n"));
  const OrderedJson json = json_of(records)["validations"];
  EXPECT_EQ(json[0]["holds"], true);
  EXPECT_EQ(json[0]["checks"][0]["tolerance_from"], "a theorem");
  EXPECT_TRUE(json[1]["holds"].is_null());
  EXPECT_EQ(json[1]["left_out"], "H2: student/angular_springs.cpp");
  EXPECT_EQ(json[2]["holds"], false);
  EXPECT_EQ(json[2]["broke"], "it threw");
}

}  // namespace
}  // namespace hair
