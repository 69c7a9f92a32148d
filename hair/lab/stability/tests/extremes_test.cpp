// STAFF ONLY. Extreme cases are as their names say, and each method has its necessary outcome.

#include "hair/lab/stability/extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <tuple>

#include "hair/io/files/bad_input.h"
#include "hair/lab/stability/maps.h"
#include "hair/lab/stability/tests/never_interrupted.h"
#include "hair/lab/stability/theory.h"
#include "hair/simulation/tests/hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

Description falling_hair() {
  Description description = alone(straight_hair(4, 0.04), Method::implicit_euler, 1e-3);
  description.gravity = kG * kDown;
  return description;
}

std::vector<std::string> names_of(const std::vector<hair::ExtremeCase>& cases) {
  std::vector<std::string> names;
  for (const hair::ExtremeCase& one : cases) names.push_back(one.name);
  return names;
}

TEST(Extremes, AreWhatTheirNamesSay) {
  const std::vector<hair::ExtremeCase> cases = hair::extreme_cases(falling_hair());
  ASSERT_EQ(cases.size(), 8u);
  const auto of = [&](const std::string& name) {
    const auto found = std::find_if(cases.begin(), cases.end(),
                                    [&](const hair::ExtremeCase& one) { return one.name == name; });
    EXPECT_NE(found, cases.end()) << name;
    return found->start;
  };
  const auto tip_height = [](const StrandStart& start) { return start.state.x[start.state.x.size() - 1]; };
  EXPECT_NEAR(tip_height(of("held level")), 0, 1e-15);
  EXPECT_NEAR(of("folded").state.x.tail<3>().norm(), 0, 1e-15);  // four segments, to and fro
  EXPECT_NEAR(tip_height(of("crushed to a hundredth")), -0.04 / 100, 1e-12);
  EXPECT_NEAR(
      hair::largest_stretch(of("torn to thrice its length").strand, of("torn to thrice its length").state.x),
      2, 1e-9);
  EXPECT_NEAR(of("its root flung at 30 m/s").state.v.head<3>().norm(), 30, 1e-12);
  const hair::Strand plain = of("held level").strand, heavy = of("a tip of 1e6 times its mass").strand;
  EXPECT_NEAR(heavy.mass[4] / plain.mass[4], 1e6, 1e-3);
  EXPECT_NEAR(of("EA 1e6 times as large").strand.stretch_rigidity / plain.stretch_rigidity, 1e6, 1e-3);
}

// A case without forces stays at rest, and shows nothing about a method.
TEST(Extremes, LeaveOutWithoutGravityWhatWouldNotMove) {
  Description floating = falling_hair();
  floating.gravity.setZero();
  floating.strands[0].strand.clamped = true;
  const std::vector<std::string> names = names_of(hair::extreme_cases(floating));
  EXPECT_EQ(names, (std::vector<std::string>{"folded", "crushed to a hundredth", "torn to thrice its length",
                                             "its root flung at 30 m/s"}));
  // A thread without weight and without bending has no oscillation across itself at all.
  Description thread = floating;
  thread.strands[0].strand.bend_rigidity = 0;
  EXPECT_THROW(hair::hang(thread, 1, false), hair::BadInput);
  Description loose = floating;
  loose.strands[0].strand.clamped = false;
  EXPECT_THROW(hair::hang(loose, 1, false), hair::BadInput);
}

// Midpoint has no limit of its own without drag; its step is half of RK4's.
TEST(Extremes, AnExplicitMethodBreaksAtCommonStepsAndNotBelowItsLimit) {
  for (const auto& [which, limit_of, from] :
       {std::tuple{Method::symplectic_euler, Method::symplectic_euler, "half its limit"},
        {Method::midpoint, Method::runge_kutta_4, "half of RK4's limit"}}) {
    hair::StudyMethod method;
    method.method = which;
    const double fastest = hair::hang(hair::with_options(falling_hair(), method), 1, false).fastest();
    const std::vector<hair::ExtremeRun> runs = hair::run_extremes(falling_hair(), method, kNeverInterrupted);
    ASSERT_EQ(runs.size(), 3 * 8u);
    for (const hair::ExtremeRun& run : runs) {
      EXPECT_EQ(run.step_from, run.h < 1e-3 ? from : "");
      if (run.step_from.empty()) {
        EXPECT_EQ(run.fate, hair::Fate::blown_up) << run.extreme << ", h " << run.h;
      } else if (run.extreme == "held level") {
        EXPECT_NEAR(run.h, hair::explicit_limit(limit_of, {fastest}) / 2, 1e-6 * run.h);
        if (which == Method::symplectic_euler) {
          EXPECT_EQ(run.fate, hair::Fate::stable);
        }
      }
    }
  }
  const std::atomic<bool> interrupted = true;
  EXPECT_TRUE(hair::run_extremes(falling_hair(), {}, interrupted).empty());
}

}  // namespace
}  // namespace reference_tests
