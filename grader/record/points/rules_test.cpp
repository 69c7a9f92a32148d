// STAFF ONLY. Tests that lateness is counted in days of the calendar, on the clock of the course's zone,
// whatever clock a download shows; a change of the clock costs nobody a day. It and the cap on extra credit
// are lines of their own. Offsets in the rows are the zones' at that time: tz database, europe and
// northamerica.
#include "grader/record/points/rules.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/record/points/shown_number.h"
#include "grader/record/points/zone.h"
#include "grader/result/json_fields.h"
#include "solver/test_refusal.h"

namespace grader::inline record {
namespace {

using Remarks = std::vector<std::string>;

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
  const struct {
    const char* handed_in;
    int days, days_with_grace;
    // In Europe the clock changed in the night to the 30th: that day had 23 hours.
  } rows[] = {{"2025-03-29 10:00:00", 0, 0},    {"2025-03-29 23:59:00", 0, 0}, {"2025-03-29 23:59:59", 0, 0},
              {"2025-03-30 00:00:00", 1, 0},    {"2025-03-30 00:09:59", 1, 0}, {"2025-03-30 00:10:00", 1, 1},
              {"2025-03-30 23:59:59", 1, 1},    {"2025-03-31 00:00:00", 2, 2}, {"2025-04-01 12:00:00", 3, 3},
              {"2026-03-29 23:59:00", 365, 365}};
  for (const auto& [handed_in, days, days_with_grace] : rows) {
    HandInRules rules = due_in_march();
    EXPECT_EQ(late_days(rules, handed_in), days) << handed_in;
    rules.grace_minutes = 10;
    EXPECT_EQ(late_days(rules, handed_in), days_with_grace) << handed_in;
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
  const struct {
    double assigned, extra;  // at most 100 and 50
    std::optional<double> share;
    double total_per_cent, total;
    const char* why = "";  // not all of it counts
  } rows[] = {{70, 0, {}, 100, 70},
              {70, 10, {}, 100, 80},
              {70, 50, {}, 100, 80, "extra credit adds at most 10 points, 10 per cent of 100"},
              {96, 10, {}, 100, 100, "no total is above 100"},
              {100, 50, {}, 100, 100, "no total is above 100"},
              {0, 50, {}, 100, 10, "extra credit adds at most 10 points, 10 per cent of 100"},
              {70, 50, 0, 100, 70, "extra credit adds at most 0 points, 0 per cent of 100"},
              {70, 20.5, 0.125, 100, 82.5, "extra credit adds at most 12.5 points, 12.5 per cent of 100"},
              {70, 30, 1, 100, 100},
              {70, 50, 1, 110, 110, "no total is above 110"},
              {0, 50, kAllExtraCredit, 1000, 50}};
  for (const auto& [assigned, extra, share, total_per_cent, total, why] : rows) {
    HandInRules rules;
    rules.extra_credit_share = share;
    rules.total_per_cent_at_most = total_per_cent;
    const SubmissionResult result = under(rules, with_points(assigned, extra), "", {});
    EXPECT_EQ(points(result), total) << why;
    EXPECT_EQ(points(result), assigned + extra_credit_counted(result)) << why;
    const std::string remark = "You reached " + shown_number(assigned + extra) +
                               " points with extra credit, and " + shown_number(total) + " of them count: ";
    EXPECT_EQ(result.remarks, *why == 0 ? Remarks{} : Remarks{remark + why});
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
        R"({"grace_minutes": "1"})", "3"})
    EXPECT_TRUE(tests::says(tests::refusal<BadInput>([&] { read(bad); }), "course.json: hand_in")) << bad;
}

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

// Berlin: forward on 2025-03-30 at 2:00, back on 2025-10-26 at 3:00. Los Angeles: forward on 2025-03-09 at
// 2:00, back on 2025-11-02 at 2:00.
TEST(Zone, LatenessBesideAChangeIsCountedOnTheCoursesClock) {
  const char *berlin = "Europe/Berlin", *angeles = "America/Los_Angeles";
  const struct {
    const char *zone, *due, *handed_in;
    int days;
  } rows[] = {
      {berlin, "2025-03-29 23:59", "2025-03-29 22:59:59 Z", 0},
      {berlin, "2025-03-29 23:59", "2025-03-29 23:00:00 Z", 1},
      {berlin, "2025-03-29 23:59", "2025-03-30 21:59:59 Z", 1},  // 23 hours later
      {berlin, "2025-03-29 23:59", "2025-03-30 22:00:00 Z", 2},
      {berlin, "2025-10-25 23:59", "2025-10-25 14:59:30 -0700", 0},
      {berlin, "2025-10-25 23:59", "2025-10-25 15:00:00 -0700", 1},
      {berlin, "2025-10-25 23:59", "2025-10-26T22:59:59Z", 1},  // 25 hours later
      {berlin, "2025-10-25 23:59", "2025-10-26T23:00:00Z", 2},
      {angeles, "2025-03-08 23:59", "2025-03-09 08:59:59 +0100", 0},
      {angeles, "2025-03-08 23:59", "2025-03-09 08:00:00 Z", 1},
      {angeles, "2025-03-08 23:59", "2025-03-10 06:59:59 Z", 1},
      {angeles, "2025-03-08 23:59", "2025-03-10 07:00:00 Z", 2},
      {angeles, "2025-11-01 23:59", "2025-11-02 06:59:59 Z", 0},
      {angeles, "2025-11-01 23:59", "2025-11-02 07:00:00 Z", 1},
      {angeles, "2025-11-01 23:59", "2025-11-03 07:59:59 Z", 1},
      {angeles, "2025-11-01 23:59", "2025-11-03 08:00:00 Z", 2},
      // Without an offset.
      {berlin, "2025-03-29 23:59", "2025-03-30 23:59:59", 1},
      {berlin, "2025-03-29 23:59", "2025-03-31 00:00:00", 2},
      {berlin, "2025-10-25 23:59", "2025-10-26 23:59:59", 1},
      {angeles, "2025-03-08 23:59", "2025-03-09 23:59:59", 1},
      {angeles, "2025-11-01 23:59", "2025-11-02 23:59:59", 1},
      // 2:30 comes twice on the 26th of October. On the 30th of March it counts as the change itself, 3:00.
      {berlin, "2025-10-26 02:30", "2025-10-26 01:30:59 Z", 0},  // the second one
      {berlin, "2025-10-26 02:30", "2025-10-26 01:31:00 Z", 1},
      {berlin, "2025-10-26 01:59", "2025-10-26 02:30:00", 1},
      {berlin, "2025-10-26 01:59", "2025-10-26 01:58:00 Z", 1},  // 2:58, 119 minutes later
      {berlin, "2025-03-30 02:30", "2025-03-30 03:00:59", 0},
      {berlin, "2025-03-30 02:30", "2025-03-30 03:01:00", 1}};
  for (const auto& [zone, due, handed_in, days] : rows)
    EXPECT_EQ(late_days(due_at(due, zone), handed_in), days) << due << " in " << zone << ": " << handed_in;
}

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
