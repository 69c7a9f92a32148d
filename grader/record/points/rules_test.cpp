// STAFF ONLY. Tests that lateness is counted in days of the calendar; it and the cap on extra credit are
// lines of their own.
#include "grader/record/points/rules.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/result/json_fields.h"

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

TEST(ExtraCredit, MakesUpForATenthAndNoMoreUnlessTheCourseSaysSo) {
  struct Row {
    double assigned, extra;  // at most 100 and 50
    std::optional<double> share;
    double total_per_cent, total;
    const char* remark;
  };
  for (const Row& row :
       {Row{70, 0, {}, 100, 70, ""}, Row{70, 10, {}, 100, 80, ""},
        Row{70,
            50,
            {},
            100,
            80,
            "You reached 120 points with extra credit, and 80 of them count: extra credit adds at most 10 "
            "points, 10 per cent of 100"},
        Row{96,
            10,
            {},
            100,
            100,
            "You reached 106 points with extra credit, and 100 of them count: no total is above 100"},
        Row{100,
            50,
            {},
            100,
            100,
            "You reached 150 points with extra credit, and 100 of them count: no total is above 100"},
        Row{0,
            50,
            {},
            100,
            10,
            "You reached 50 points with extra credit, and 10 of them count: extra credit adds at most 10 "
            "points, 10 per cent of 100"},
        Row{70, 50, 0, 100, 70,
            "You reached 120 points with extra credit, and 70 of them count: extra credit adds at most 0 "
            "points, 0 per cent of 100"},
        Row{70, 20.5, 0.125, 100, 82.5,
            "You reached 90.5 points with extra credit, and 82.5 of them count: extra credit adds at most "
            "12.5 points, 12.5 per cent of 100"},
        Row{70, 30, 1, 100, 100, ""},
        Row{70, 50, 1, 110, 110,
            "You reached 120 points with extra credit, and 110 of them count: no total is above 110"},
        Row{0, 50, kAllExtraCredit, 1000, 50, ""}}) {
    HandInRules rules;
    rules.extra_credit_share = row.share;
    rules.total_per_cent_at_most = row.total_per_cent;
    const SubmissionResult result = under(rules, with_points(row.assigned, row.extra), "", {});
    EXPECT_EQ(points(result), row.total) << row.remark;
    EXPECT_EQ(points(result), row.assigned + extra_credit_counted(result)) << row.remark;
    EXPECT_EQ(result.remarks.empty() ? "" : result.remarks.at(0), row.remark);
    EXPECT_TRUE(result.adjustments.empty());
  }
  HandInRules late = due_in_march();
  EXPECT_EQ(points(under(late, with_points(70, 50), "2025-03-30 12:00:00", {})), 72)
      << "lateness is taken off last";
  SubmissionResult only_extra = with_points(0, 50);
  only_extra.exercises.erase(only_extra.exercises.begin());
  EXPECT_EQ(points(under({}, only_extra, "", {})), 50) << "there is nothing else to make up for";
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
        R"({"extra_credit_share": 1.1})", R"({"extra_credit_share": -0.1})",
        R"({"extra_credit_share": "0.1"})", R"({"late_of": "all"})", R"({"lateness": 1})",
        R"({"grace_minutes": "1"})", "3"}) {
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
