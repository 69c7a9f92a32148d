// STAFF ONLY. A study's errors fall as theory says, with the reference.
#include <gtest/gtest.h>

#include <cmath>

#include "hair/lab/study/observed_order.h"
#include "studies.h"

namespace reference_tests {
namespace {

using hair::Norm;

// An error c h^p (1 + d h + ...) shows the order p + d h / (2 ln 2) from h to h/2: each halving of the
// step halves the deviation, so the last order is off by as much as it differs from the previous one. The
// bound adds half as much for the terms that follow, and 0.02 for the reference's own error, which is
// below 1/100 of these. At a single moment c may pass through 0; over all of them it does not.
void expect_order(const hair::Study& study, const std::string& id, int order) {
  const Norm norm = Norm::trajectory;
  const hair::Sweep& sweep = sweep_of(study, id);
  std::vector<double> errors;
  for (const hair::MethodRun& run : sweep.runs)
    if (run.ending == hair::RunEnding::finished && run.errors[norm] > 100 * study.floors[norm])
      errors.push_back(run.errors[norm]);
  const std::size_t n = errors.size();
  ASSERT_GE(n, 3u) << shown(sweep);
  const double last = std::log2(errors[n - 2] / errors[n - 1]),
               before = std::log2(errors[n - 3] / errors[n - 2]);
  EXPECT_LE(std::abs(last - before), 0.25) << "not asymptotic\n" << shown(sweep);
  EXPECT_LE(std::abs(last - order), 1.5 * std::abs(last - before) + 0.02)
      << "orders " << before << ", " << last << "\n"
      << shown(sweep);
  // The study finds the same order.
  const hair::ObservedOrder seen = hair::observed_order(sweep, norm, study.floors[norm]);
  ASSERT_TRUE(seen.order) << shown(sweep);
  EXPECT_NEAR(*seen.order, order, 0.25) << shown(sweep);  // the halvings that it takes agree to within that
  EXPECT_EQ(hair::verdict(sweep, seen), "as theory has it") << shown(sweep);
}

// RK4 is not among them: it is at the floor before its order can be seen.
TEST(KnownOrders, OfSoftHair) {
  const hair::Study study =
      studied(kSoftHair, 0.1, {"forward-euler", "symplectic-euler", "midpoint", "h4-filtered", "h4-dropped"},
              2e6)
          .whole();
  expect_order(study, "forward-euler", 1);
  expect_order(study, "symplectic-euler", 1);
  expect_order(study, "midpoint", 2);
  expect_order(study, "h4-filtered", 1);
  expect_order(study, "h4-dropped", 1);
}

TEST(KnownOrders, OfAPendulum) {
  const hair::Study study =
      studied(kPendulum, 0.4,
              {"forward-euler", "symplectic-euler", "midpoint", "runge-kutta-4", "h4-filtered"}, 5e5)
          .whole();
  expect_order(study, "forward-euler", 1);
  expect_order(study, "symplectic-euler", 1);
  expect_order(study, "midpoint", 2);
  expect_order(study, "runge-kutta-4", 4);
  expect_order(study, "h4-filtered", 1);
}

// Once its errors are below the reference's accuracy, a method has no finer steps, and none of these errors
// is quoted.
TEST(KnownOrders, ASweepEndsAtTheFloor) {
  const hair::Study study = studied(kPendulum, 0.1, {"runge-kutta-4"}, 1e7).whole();
  const hair::Sweep& sweep = study.sweeps[0];
  EXPECT_EQ(sweep.end, hair::SweepEnd::floor) << shown(sweep);
  const Norm norm = Norm::trajectory;
  EXPECT_LT(sweep.runs.back().errors[norm], study.floors[norm]);
  EXPECT_GE(sweep.runs[sweep.runs.size() - 2].errors[norm], study.floors[norm]) << shown(sweep);
}

}  // namespace
}  // namespace reference_tests
