// STAFF ONLY. Tests that every struct of results, studies and costs survives its declared fields.

#include <gtest/gtest.h>

#include <limits>

#include "grader/result/check_fields.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "solver/test_refusal.h"

namespace grader::inline result {
namespace {

using namespace std::string_literals;
using tests::says;

// All members differ from their defaults.
const PictureResult kPicture{.name = "0.50 s",
                             .blurred_rmse = 0.1,
                             .flip = 0.2,
                             .student = "\x89PNG\0theirs"s,
                             .reference = "\xff\x00ours"s,
                             .heat = "heat",
                             .far_off = true,
                             .breaks_off = true,
                             .apart = 12};

const CaseResult kCase{.name = "Ill-conditioned systems",
                       .status = Status::broke_rules,
                       .points = 1.0 / 3,
                       .max_points = 1e300,
                       .feedback = "the residual is \"large\"",
                       .detail = "n = 10\nx = -0x1p-1074 ö",
                       .hint = "It is right but for signs.",
                       .cases = 7,
                       .held = std::numeric_limits<int>::max()};

SubmissionResult submission() {
  ExerciseResult exercise;
  exercise.id = "S1";
  exercise.title = "Conjugate gradients";
  exercise.file = "conj_grad.cpp";
  exercise.extra_credit = true;
  exercise.status = Status::timed_out;
  exercise.points = 12.5;
  exercise.max_points = 32;
  exercise.feedback = "A call did not return.";
  exercise.compiler_messages = "warning: unused";
  exercise.cases = {kCase, {}};
  exercise.pictures = {kPicture};
  exercise.staff_log = "log\n";
  exercise.source = "int x;\n";
  exercise.said = {{"S1:1", "int x;", "The staff say: call it n"}};
  SubmissionResult result;
  result.name = "alice";
  result.exercises = {exercise, {}};
  result.note = "a note";
  result.fingerprint = "abc";
  result.isolation = Isolation::container;
  result.images = false;
  result.studied = true;
  result.origin = "hand-in /home/ta/alice.zip";
  result.ended_by_the_clock = {"S1", "runs"};
  result.extra_credit_counted = 2.5;
  result.adjustments = {{"late by 2 days", -1.5}};
  result.remarks = {"a remark"};
  result.about = "Hours: 3\n";
  return result;
}

SubmissionStudy study() {
  StudyPoint point;
  point.steps = 64;
  point.end = StudyEnd::finished;
  point.note = "a note";
  point.error = 1e-9;
  point.solver_steps = -1;  // as the worker reports
  point.correction_steps = std::numeric_limits<std::int64_t>::max();
  point.first_seconds = 0.5;
  point.seconds = {0.25, 1.0 / 7};
  PartStudy part;
  part.name = "pendulums, midpoint";
  part.duration = 2;
  part.own_steps = 100;
  part.order = 2;
  part.truth = "CVODE";
  part.least_error = 1e-12;
  part.rounds = 5;
  part.student = {.points = {point}, .stable_steps = 32, .stable_everywhere = true};
  part.reference = {.points = {point, point}, .stable_steps = 16, .stable_everywhere = true};
  part.ratio = {.median = 1.5, .least = 0.5, .most = 2};
  part.note = "one round was left out";
  return {.scenes =
              {{.name = "pendulums", .shows = "two pendulums", .left_out = "H4 is missing", .parts = {part}}},
          .student_seconds = 3.5,
          .reference_seconds = 4.5};
}

Budget budget() {
  Budget all;
  double value = 0.1;
  for (const BudgetField& one : budget_fields()) all.*one.value = value += 1;
  return all;
}

SuiteResult suite_result() {
  SuiteResult found;
  found.cases = {kCase};
  found.pictures = {kPicture};
  found.motions = {"theirs", "ours", "both"};
  found.study = study();
  found.cpu_seconds = 0.1;
  found.run_cpu_seconds = 0.2;
  found.picture_cpu_seconds = 0.3;
  found.starts = 4;
  found.spent = budget();
  found.reproduced = {{"main.cpp", "int main() {}\n"}};
  return found;
}

ClassCosts costs() {
  ExerciseTiming timing;
  timing.compile_seconds = 1;
  timing.suite_seconds = 2;
  timing.worker_cpu_seconds = 3;
  timing.worker_starts = 4;
  timing.spent = budget();
  timing.run_cpu_seconds = 6;
  timing.picture_cpu_seconds = 7;
  return {.reference = {{"S1", timing}},
          .submissions = {{"alice", {{"S1", timing}, {"runs", {}}}}, {"bob", {}}},
          .ended_by_the_clock = {{"alice", {"S1", "runs"}}},
          .last_run = LastRun{.wall_seconds = 30,
                              .graded = 2,
                              .jobs = 4,
                              .began = "2025-03-04 10:15:22",
                              .ended = "2025-03-04 10:15:52",
                              .asked = 3,
                              .done = 2}};
}

template <class T>
void read_as(const std::string& text) {
  from_json_text<T>(text, "a.json");
}

// These fields are written only if they differ from their defaults.
bool may_be_missing(const std::string& place) {
  const std::string key = place.substr(place.rfind('/') + 1);
  if (place.find("/points/") != place.npos)
    return key == "note" || key == "error" || key == "solver_steps" || key == "correction_steps";
  return key == "hint" || key == "breaks_off" || key == "apart" || key == "motions" || key == "studied" ||
         key == "ended_by_the_clock" || key == "extra_credit_counted" || key == "source" || key == "said" ||
         key == "adjustments" || key == "remarks" || key == "about" || key == "last_run" || key == "began" ||
         key == "ended" || key == "asked" || key == "done" || key == "alice" || key == "bob" || key == "S1" ||
         key == "runs" || key == "main.cpp";
}

template <class T>
void expect_declared(const T& value) {
  const std::string text = json_text(value, -1);
  EXPECT_EQ(from_json_text<T>(text, "a.json"), value) << text;
  EXPECT_EQ(from_json_text<T>(json_text(T{}, 2), "a.json"), T{});
  const OrderedJson filled = OrderedJson::parse(text), empty = OrderedJson::parse(json_text(T{}, -1));
  for (const Field<T>& row : Fields<T>::rows())
    EXPECT_TRUE(!row.write ||
                (filled.contains(row.key) && (!empty.contains(row.key) || filled[row.key] != empty[row.key])))
        << row.key << ": this test gives it another value than its default";
  expect_each_field_checked(nlohmann::json::parse(text), read_as<T>, may_be_missing);
}

TEST(DeclaredFields, ComeBackWholeAndEachIsChecked) {
  expect_declared(submission());
  expect_declared(study());
  expect_declared(suite_result());
  expect_declared(costs());
  EXPECT_EQ(from_json_text<ClassCosts>(to_json(costs()), "a.json"), costs());
}

TEST(DeclaredFields, AreLeftOutWhereTheySayNothing) {
  const auto written = [](StudyEnd end) {
    StudyPoint point;
    point.end = end;
    return json_text(point, -1);
  };
  EXPECT_EQ(written(StudyEnd::finished),
            "{\"steps\":0,\"end\":\"finished\",\"error\":0.0,\"solver_steps\":0,\"correction_steps\":0,"
            "\"first_seconds\":0.0,\"seconds\":[]}\n");
  EXPECT_EQ(
      written(StudyEnd::ran_away),
      "{\"steps\":0,\"end\":\"ran away\",\"solver_steps\":0,\"correction_steps\":0,\"first_seconds\":0.0,"
      "\"seconds\":[]}\n");
  EXPECT_EQ(written(StudyEnd::broke),
            "{\"steps\":0,\"end\":\"broke\",\"first_seconds\":0.0,\"seconds\":[]}\n");
  EXPECT_EQ(json_text(submission(), -1).find("\"studied\"") != std::string::npos, true);
  EXPECT_FALSE(says(json_text(SubmissionResult{}, -1), "\"studied\""));
}

TEST(DeclaredFields, PutPicturesWhereTheyAreTold) {
  const PictureText named{[](const std::string& png) { return "name of " + png; },
                          [](const std::string& text) { return text.substr(8); }};
  PictureResult picture = kPicture;
  picture.student = "theirs";
  picture.reference = picture.heat = "";
  const std::string text = json_text(picture, -1, named);
  EXPECT_TRUE(says(text, "\"student\":\"name of theirs\",\"reference\":\"name of \""));
  EXPECT_EQ(from_json_text<PictureResult>(text, "a.json", named), picture);
}

TEST(DeclaredFields, OfEarlierVersionsAreReadOver) {
  const SubmissionResult now = submission();
  OrderedJson then = OrderedJson::parse(json_text(now, -1));
  then["runs"] = {{{"name", "swing"}, {"pictures", OrderedJson::array()}}};
  then["exercises"][0]["allocations"] = 3;
  then["exercises"][0]["cases"][0]["memory_error"] = "It reads behind an array, in a call of f.";
  then["exercises"][0]["pictures"][0]["flip_limit"] = 0.001;
  EXPECT_EQ(from_json_text<SubmissionResult>(then.dump(), "a.json"), now);
  then = OrderedJson::parse(json_text(costs(), -1));
  then["reference"]["S1"]["sanitised_cpu_seconds"] = 5;
  EXPECT_EQ(from_json_text<ClassCosts>(then.dump(), "a.json"), costs());
}

TEST(DeclaredFields, HostileTextIsWrittenAsUtf8) {
  CaseResult one = kCase;
  one.detail = "\xff\0\x1b[31m"s;
  EXPECT_EQ(from_json_text<CaseResult>(json_text(one, 1), "a.json").detail, "\xef\xbf\xbd\0\x1b[31m"s);
}

struct Slip {
  const char *part, *replacement, *sentence;
};

// These places are in the JSON of suite_result().
constexpr Slip kSlips[] = {
    {R"("status":"broke the rules")", R"("status":"fine")",
     "a.json: cases[0].status: \"fine\" is not right; write one of: passed, partly, wrong, not implemented, "
     "missing, does not compile, crashed, timed out, out of memory, broke the rules, not taken, "
     "can't be read, given, not given yet, excused"},
    {R"("held":2147483647)", R"("held":2147483648)",
     "a.json: cases[0].held: 2147483648 is not right; write a whole number from -2147483648 to 2147483647"},
    {R"("cases":7)", R"("cases":7.5)",
     "a.json: cases[0].cases: 7.5 is not right; write a whole number from -2147483648 to 2147483647"},
    {R"("solver_steps":-1)", R"("solver_steps":9223372036854775808)",
     "a.json: study.scenes[0].parts[0].student.points[0].solver_steps: 9223372036854775808 is not right; "
     "write a "
     "whole number from -9223372036854775808 to 9223372036854775807"},
    {R"("max_points":1e+300)", R"("max_points":null)",
     "a.json: cases[0].max_points: null is not a number; write one"},
    {R"("far_off":true)", R"("far_off":1)",
     "a.json: pictures[0].far_off: 1 is not right; write true or false"},
    {R"("heat":"aGVhdA==")", R"("heat":"aGVhdA=")", "a.json: pictures[0].heat: not base64"},
    {R"("starts":4)", R"("starts":4,"starts":4)",
     "a.json: \"starts\" stands twice in the same object; keep one of them"},
    {R"("starts":4)", R"("starts":4,"weight":1)",
     "a.json: unknown key \"weight\"; known here: cases, pictures, motions, study, "
     "cpu_seconds, "
     "run_cpu_seconds, picture_cpu_seconds, starts, spent, reproduced"},
    {R"("starts":4,)", "",
     "a.json: \"starts\" is missing; an object here has: cases, pictures, motions, study, "
     "cpu_seconds, run_cpu_seconds, picture_cpu_seconds, starts, spent, reproduced"},
};

TEST(DeclaredFields, TellWhatIsWrongAndWhere) {
  const std::string whole = json_text(suite_result(), -1);
  for (const auto& [part, replacement, sentence] : kSlips) {
    std::string text = whole;
    const std::size_t at = text.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    text.replace(at, std::string(part).size(), replacement);
    EXPECT_EQ(complaint_about(text, read_as<SuiteResult>), sentence);
  }
}

TEST(DeclaredFields, OfHostileTextsAreRefusedInOneLine) {
  const std::string deep(100'000, '[');
  std::string whole = json_text(suite_result(), -1);
  whole.replace(whole.find("\"starts\":4"), 10, "\"starts\":1e999");
  for (const std::string& text : {""s, "null"s, "[]"s, "{}"s, "\0"s, "\x1b[31m"s, deep, "{\"cases\":" + deep,
                                  whole, "{\"" + std::string(100'000, 'a') + "\":1}"})
    expect_one_line(complaint_about(text, read_as<SuiteResult>), "", text.substr(0, 20));
}

}  // namespace
}  // namespace grader::result
