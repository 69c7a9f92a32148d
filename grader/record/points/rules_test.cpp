// STAFF ONLY. Tests that lateness is counted in days of the calendar; it and the cap on extra credit are
// lines of their own.
#include "grader/record/points/rules.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"

namespace grader::inline record {
namespace {

HandInRules due_in_march() {
  HandInRules rules;
  rules.due = "2025-03-29 23:59";
  rules.late_per_cent_a_day = 10;
  return rules;
}

SubmissionResult with_points(double assigned, double extra) {
  SubmissionResult result;
  result.exercises.resize(2);
  result.exercises[0].points = assigned;
  result.exercises[0].max_points = 100;
  result.exercises[1].points = extra;
  result.exercises[1].max_points = 50;
  result.exercises[1].extra_credit = true;
  return result;
}

TEST(Lateness, IsCountedInDaysOfTheCalendar) {
  struct Row {
    const char* handed_in;
    int days, days_with_grace;
  };
  // In Europe the clock changed in the night to the 30th: that day had 23 hours.
  for (const Row& row :
       {Row{"2025-03-29 10:00:00", 0, 0}, Row{"2025-03-29 23:59:00", 0, 0}, Row{"2025-03-29 23:59:59", 0, 0},
        Row{"2025-03-30 00:00:00", 1, 0}, Row{"2025-03-30 00:09:59", 1, 0}, Row{"2025-03-30 00:10:00", 1, 1},
        Row{"2025-03-30 23:59:59", 1, 1}, Row{"2025-03-31 00:00:00", 2, 2}, Row{"2025-04-01 12:00:00", 3, 3},
        Row{"2026-03-29 23:59:00", 365, 365}}) {
    HandInRules rules = due_in_march();
    EXPECT_EQ(late_days(rules, row.handed_in), row.days) << row.handed_in;
    rules.grace_minutes = 10;
    EXPECT_EQ(late_days(rules, row.handed_in), row.days_with_grace) << row.handed_in;
  }
  EXPECT_FALSE(late_days(due_in_march(), ""));
  EXPECT_FALSE(late_days(due_in_march(), "yesterday at noon"));
  EXPECT_FALSE(late_days({}, "2025-03-29 10:00:00"));
}

TEST(Lateness, TakesAShareOfWhatIsReachedOrReachable) {
  HandInRules rules = due_in_march();
  const auto total = [&](const char* handed_in, double more_days) {
    return points(under(rules, with_points(60, 0), handed_in, {.given = more_days}));
  };
  EXPECT_EQ(total("2025-03-29 23:59:30", 0), 60);
  EXPECT_EQ(total("2025-03-31 12:00:00", 0), 60 - 12);
  EXPECT_EQ(total("2025-03-31 12:00:00", 1), 60 - 6) << "a person gave a day";
  rules.free_days = 1;
  EXPECT_EQ(total("2025-03-31 12:00:00", 0), 60 - 6);
  EXPECT_EQ(total("2025-03-31 12:00:00", 5), 60);
  rules.late_of = LateOf::reachable;
  EXPECT_EQ(total("2025-03-31 12:00:00", 0), 60 - 10);
  EXPECT_EQ(total("2025-05-31 12:00:00", 0), 0) << "never below";
  rules.late_per_cent_at_most = 30;
  EXPECT_EQ(total("2025-05-31 12:00:00", 0), 60 - 30);
  EXPECT_EQ(under(rules, with_points(60, 0), "2025-03-31 12:00:00", {}).adjustments.at(0).reason,
            "Late by 2 days, handed in 2025-03-31 12:00:00, due 2025-03-29 23:59, 1 day of them free; 10 per "
            "cent of "
            "the points reachable are taken off");
}

TEST(ExtraCredit, MakesUpForLostPointsAndNoMoreUnlessTheCourseSaysSo) {
  EXPECT_EQ(points(under({}, with_points(70, 20), "", {})), 90);
  const SubmissionResult capped = under({}, with_points(70, 50), "", {});
  EXPECT_EQ(points(capped), 100);
  EXPECT_EQ(capped.adjustments.at(0).reason,
            "With extra credit the total counts up to 100 per cent of 100 points");
  HandInRules rules = due_in_march();
  rules.total_per_cent_at_most = 110;
  EXPECT_EQ(points(under(rules, with_points(70, 50), "", {})), 110);
  EXPECT_EQ(points(under(rules, with_points(70, 50), "2025-03-30 12:00:00", {})), 99)
      << "lateness is taken off last";
  EXPECT_EQ(points(under({}, SubmissionResult{}, "", {})), 0);
}

TEST(Rules, AreReadFromTheCourseFile) {
  const auto read = [](const std::string& hand_in) {
    const nlohmann::json document =
        hair::parse_json(R"({"exercises": {}, "hand_in": )" + hand_in + "}", "course.json");
    HandInRules rules;
    read_rules(JsonValue(document, "course.json")["hand_in"], rules);
    return rules;
  };
  EXPECT_EQ(read("{}"), HandInRules{});
  const HandInRules rules = read(R"({"due": "2025-03-29 23:59", "late_per_cent_a_day": 10})");
  EXPECT_EQ(rules, due_in_march());
  EXPECT_EQ(from_json_text<HandInRules>(json_text(rules, -1), "x"), rules);
  for (const char* bad :
       {R"({"due": "tomorrow"})", R"({"due": "2025-02-30 10:00"})", R"({"due": "2025-03-29 23:59:10"})",
        R"({"zone": "Berlin"})", R"({"zone": ""})", R"({"late_per_cent_a_day": 101})", R"({"free_days": -1})",
        R"({"late_of": "all"})", R"({"lateness": 1})", R"({"grace_minutes": "1"})", "3"}) {
    try {
      read(bad);
      ADD_FAILURE() << bad;
    } catch (const BadInput& line) {
      EXPECT_NE(std::string(line.what()).find("course.json: hand_in"), std::string::npos) << line.what();
    }
  }
}

}  // namespace
}  // namespace grader::record
