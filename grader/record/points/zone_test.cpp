// STAFF ONLY. Tests that lateness is counted on the clock of the course's zone, whatever clock a download
// shows, and that a change of the clock costs nobody a day. Offsets in the rows are the zones' at that time:
// tz database, europe and northamerica.
#include "grader/record/points/zone.h"

#include <gtest/gtest.h>

#include "grader/record/points/rules.h"

namespace grader::inline record {
namespace {

HandInRules due_at(const char* due, const char* zone) {
  HandInRules rules;
  rules.due = due;
  rules.zone = zone;
  return rules;
}

TEST(Zone, IsANameOfTheList) {
  for (const char* name : {"Europe/Berlin", "America/Los_Angeles", "Asia/Kathmandu", "UTC"})
    EXPECT_TRUE(is_zone(name)) << name;
  for (const char* name :
       {"", "Europe", "europe/berlin", "Europe/Berln", "localtime", "+01:00", "../etc/passwd"})
    EXPECT_FALSE(is_zone(name)) << name;
}

struct Row {
  const char* zone;
  const char* due;
  const char* handed_in;
  int days;
};

class LatenessBesideAChange : public testing::TestWithParam<Row> {};

TEST_P(LatenessBesideAChange, IsCountedOnTheCoursesClock) {
  const Row& row = GetParam();
  EXPECT_EQ(late_days(due_at(row.due, row.zone), row.handed_in), row.days)
      << "due " << row.due << " in " << row.zone << ", handed in " << row.handed_in;
}

// Berlin: forward on 2025-03-30 at 2:00, back on 2025-10-26 at 3:00. Los Angeles: forward on 2025-03-09 at
// 2:00, back on 2025-11-02 at 2:00.
INSTANTIATE_TEST_SUITE_P(
    Offsets, LatenessBesideAChange,
    testing::Values(Row{"Europe/Berlin", "2025-03-29 23:59", "2025-03-29 22:59:59 Z", 0},
                    Row{"Europe/Berlin", "2025-03-29 23:59", "2025-03-29 23:00:00 Z", 1},
                    Row{"Europe/Berlin", "2025-03-29 23:59", "2025-03-30 21:59:59 Z", 1},  // 23 hours later
                    Row{"Europe/Berlin", "2025-03-29 23:59", "2025-03-30 22:00:00 Z", 2},
                    Row{"Europe/Berlin", "2025-10-25 23:59", "2025-10-25 14:59:30 -0700", 0},
                    Row{"Europe/Berlin", "2025-10-25 23:59", "2025-10-25 15:00:00 -0700", 1},
                    Row{"Europe/Berlin", "2025-10-25 23:59", "2025-10-26T22:59:59Z", 1},  // 25 hours later
                    Row{"Europe/Berlin", "2025-10-25 23:59", "2025-10-26T23:00:00Z", 2},
                    Row{"America/Los_Angeles", "2025-03-08 23:59", "2025-03-09 08:59:59 +0100", 0},
                    Row{"America/Los_Angeles", "2025-03-08 23:59", "2025-03-09 08:00:00 Z", 1},
                    Row{"America/Los_Angeles", "2025-03-08 23:59", "2025-03-10 06:59:59 Z", 1},
                    Row{"America/Los_Angeles", "2025-03-08 23:59", "2025-03-10 07:00:00 Z", 2},
                    Row{"America/Los_Angeles", "2025-11-01 23:59", "2025-11-02 06:59:59 Z", 0},
                    Row{"America/Los_Angeles", "2025-11-01 23:59", "2025-11-02 07:00:00 Z", 1},
                    Row{"America/Los_Angeles", "2025-11-01 23:59", "2025-11-03 07:59:59 Z", 1},
                    Row{"America/Los_Angeles", "2025-11-01 23:59", "2025-11-03 08:00:00 Z", 2}));

INSTANTIATE_TEST_SUITE_P(
    WithoutOffset, LatenessBesideAChange,
    testing::Values(Row{"Europe/Berlin", "2025-03-29 23:59", "2025-03-30 23:59:59", 1},
                    Row{"Europe/Berlin", "2025-03-29 23:59", "2025-03-31 00:00:00", 2},
                    Row{"Europe/Berlin", "2025-10-25 23:59", "2025-10-26 23:59:59", 1},
                    Row{"America/Los_Angeles", "2025-03-08 23:59", "2025-03-09 23:59:59", 1},
                    Row{"America/Los_Angeles", "2025-11-01 23:59", "2025-11-02 23:59:59", 1}));

// 2:30 comes twice on the 26th of October, and not at all on the 30th of March, where it counts as the change
// itself, 3:00.
INSTANTIATE_TEST_SUITE_P(WithinTheChange, LatenessBesideAChange,
                         testing::Values(Row{"Europe/Berlin", "2025-10-26 02:30", "2025-10-26 01:30:59 Z",
                                             0},  // the second one
                                         Row{"Europe/Berlin", "2025-10-26 02:30", "2025-10-26 01:31:00 Z", 1},
                                         Row{"Europe/Berlin", "2025-10-26 01:59", "2025-10-26 02:30:00", 1},
                                         Row{"Europe/Berlin", "2025-10-26 01:59", "2025-10-26 01:58:00 Z",
                                             1},  // 2:58, 119 minutes later
                                         Row{"Europe/Berlin", "2025-03-30 02:30", "2025-03-30 03:00:59", 0},
                                         Row{"Europe/Berlin", "2025-03-30 02:30", "2025-03-30 03:01:00", 1}));

TEST(Lateness, GivesTheGraceInMinutesThatPass) {
  HandInRules rules = due_at("2025-03-30 01:55", "Europe/Berlin");
  rules.grace_minutes = 10;
  EXPECT_EQ(late_days(rules, "2025-03-30 03:05:59"), 0) << "10 minutes later, since 2:00 was 3:00";
  EXPECT_EQ(late_days(rules, "2025-03-30 03:06:00"), 1);
  rules.due = "2025-10-26 01:55";
  EXPECT_EQ(late_days(rules, "2025-10-26 01:04:00 Z"), 1) << "69 minutes later, though the clock shows 2:04";
}

TEST(Lateness, IsToldOnTheCoursesClock) {
  HandInRules rules = due_at("2025-03-04 23:59", "Europe/Berlin");
  rules.late_per_cent_a_day = 10;
  SubmissionResult result;
  result.exercises.resize(1);
  result.exercises[0].points = result.exercises[0].max_points = 10;
  EXPECT_EQ(
      under(rules, result, "2025-03-04 15:15:22 -0800", {}).adjustments.at(0).reason,
      "Late by 1 day, handed in 2025-03-05 00:15:22, due 2025-03-04 23:59; 10 per cent of the points reached "
      "are taken off");
}

}  // namespace
}  // namespace grader::record
