// STAFF ONLY. A study exposes methods that are wrong: in words, in its orders and in its figures.
#include <gtest/gtest.h>

#include "hair/lab/study/observed_order.h"
#include "hair/lab/study/study_record.h"
#include "studies.h"

namespace reference_tests {
namespace {

using hair::Norm;

TEST(WrongMethod, IsExposed) {
  const hair::Study study =
      studied(kPendulum, 0.1, {"forward-euler", "symplectic-euler", "midpoint", "runge-kutta-4"}, 2e6)
          .whole();
  const auto seen = [&](const char* id) {
    return hair::observed_order(sweep_of(study, id), Norm::trajectory, study.floors[Norm::trajectory]);
  };
  const auto said = [&](const char* id) { return hair::verdict(sweep_of(study, id), seen(id)); };
  for (const char* right : {"forward-euler", "symplectic-euler"}) EXPECT_EQ(said(right), "as theory has it");

  // It has order 1 instead of 2.
  ASSERT_TRUE(seen("midpoint").order) << shown(sweep_of(study, "midpoint"));
  EXPECT_NEAR(*seen("midpoint").order, 1, 0.25) << shown(sweep_of(study, "midpoint"));
  EXPECT_EQ(said("midpoint"), "less than theory says");

  // RK4 converges to another motion: 1 % of gravity's effect in a tenth of a second, 0.01 * 9.81 * 0.1^2 / 2
  // = 5e-4 m, and at least a tenth of that because springs hold.
  const hair::ObservedOrder off = seen("runge-kutta-4");
  ASSERT_TRUE(off.stays_at) << shown(sweep_of(study, "runge-kutta-4"));
  EXPECT_GT(*off.stays_at, 5e-5);
  EXPECT_LT(*off.stays_at, 5e-4);
  EXPECT_EQ(sweep_of(study, "runge-kutta-4").end, hair::SweepEnd::stalls)
      << shown(sweep_of(study, "runge-kutta-4"));

  const std::string html = hair::to_html(hair::study_page(study));
  EXPECT_NE(html.find("less than theory says"), std::string::npos);
  EXPECT_NE(html.find("m off, however small the step"), std::string::npos);
}

}  // namespace
}  // namespace reference_tests
