// STAFF ONLY. Tests that a student's report leads to the lost points.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sstream>

#include "grader/report/facts/class_statistics.h"
#include "grader/report/facts/sample_results.h"
#include "grader/report/facts/student_text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/points_files.h"
#include "grader/report/report.h"
#include "grader/report/results_json.h"
#include "solver/test_refusal.h"

namespace grader::inline report {
namespace {

using tests::says;

SubmissionResult two_exercises() {
  return {.name = "alice",
          .exercises = {{.id = "S1", .status = Status::passed, .cases = {{"Sizes", Status::passed}}},
                        {.id = "H1",
                         .status = Status::partly,
                         .cases = {{"Energies", Status::passed},
                                   {"Forces", Status::wrong},
                                   {"Limits", Status::timed_out},
                                   {"Products", Status::wrong}}}}};
}

TEST(SubmissionPage, ShowsLossesFirstAndFoldsTheRest) {
  for (const std::string& page : {student_page(two_exercises()), staff_page(two_exercises())}) {
    const std::size_t h1 = page.find("<section id=\"H1\">"), s1 = page.find("<section id=\"S1\">");
    EXPECT_LT(h1, s1);
    const std::size_t folded = page.find("1 of 4 categories pass", h1);
    EXPECT_LT(folded, page.find("Energies"));
    EXPECT_LT(page.find("Products"), folded) << "what is wrong stands open";
    EXPECT_NE(page.find("1 of 1 categories pass", s1), std::string::npos);
    EXPECT_LT(page.find("H1.4"), page.find("H1.1")) << "numbers are those of the course";
  }
}

TEST(SubmissionPage, SaysOnceWhereToGoOn) {
  const std::string page = student_page(two_exercises());
  EXPECT_EQ(times(page, "check-H1 asks the same"), 1U);
  EXPECT_EQ(times(page, "check-S1"), 0U) << "nothing is wrong there";
  EXPECT_EQ(times(page, "public checks"), 0U) << "not in each row";
}

TEST(SubmissionPage, ShowsTheCompilersWordsOnce) {
  SubmissionResult result = two_exercises();
  ExerciseResult& one = result.exercises[0];
  one.compiler_messages = "a.cpp:1: first\na.cpp:2: second\n";
  one.staff_log = "a.cpp:1: first\na.cpp:2: second\n/usr/bin/ld: third\n";
  for (const char* words : {"a.cpp:1: first", "a.cpp:2: second", "/usr/bin/ld: third"})
    EXPECT_EQ(times(staff_page(result), words), 1U) << words;
  one.staff_log = one.compiler_messages;
  EXPECT_EQ(times(staff_page(result), "worker printed"), 0U);
}

TEST(SubmissionPage, ShowsStaffTheSourceWithMessagesAtTheirLines) {
  SubmissionResult result = two_exercises();
  ExerciseResult& one = result.exercises[1];
  one.file = "a.cpp";
  one.source = "// <first>\ndouble energy(int n) {\n  return helper(n);\n}\n";
  one.compiler_messages =
      "a.cpp:3:10: warning: <narrow>\na.cpp:99: beyond the end\nb.cpp:1: of another file\n";
  one.staff_log =
      "a.cpp:3:10: warning: <narrow>\na.cpp:(.text+0x9): undefined reference to `x::helper(int)'\n";
  const std::string page = staff_page(result),
                    source = page.substr(page.find("a.cpp, 4 lines; messages at 3"));
  EXPECT_EQ(page.find("<details open=\"\"><summary>a.cpp, 4 lines"), page.find(source) - 26);
  EXPECT_EQ(times(student_page(result), "double energy"), 0U);
  const std::pair<const char*, const char*> at[] = {{"    3   return", "a.cpp:3:10: warning: &lt;narrow&gt;"},
                                                    {"    3   return", "undefined reference to"}};
  for (const auto& [line, message] : at) {
    EXPECT_LT(source.find(line), source.find(message)) << message;
    EXPECT_EQ(times(source, message), 1U) << message;
  }
  EXPECT_EQ(times(source, "beyond the end") + times(source, "of another file"), 0U);
  EXPECT_EQ(times(source, "    1 // &lt;first&gt;"), 1U);
  one.source += std::string(40, '\n');
  EXPECT_EQ(times(staff_page(result), "<details><summary>a.cpp, 44 lines"), 1U) << "long ones are folded";
}

TEST(SubmissionPage, SaysWhyAPictureIsCoarseAndThatThereIsNone) {
  SubmissionResult result = two_exercises();
  result.exercises[1].cases.push_back({kRunTitle, Status::crashed});
  const std::string none = "The whole run broke off before its first picture.";
  EXPECT_EQ(times(student_page(result), none), 1U);
  result.exercises[1].pictures = {sample_picture("1.00 s", 40)};
  EXPECT_EQ(times(student_page(result), none), 0U);
  EXPECT_EQ(times(student_page(result), "shown coarsely"), 0U);
  result.exercises[1].pictures[0].far_off = true;
  EXPECT_EQ(times(student_page(result), "shown coarsely: it is far from the reference&#39;s"), 1U);
  EXPECT_EQ(times(staff_page(result), "shown coarsely"), 0U) << "staff see it as it is";
}

TEST(SubmissionPage, SaysOnceWhyNotAllExtraCreditCounts) {
  SubmissionResult result = two_exercises();
  result.exercises[1].extra_credit = true;
  result.exercises[1].points = 15;
  result.exercises[0].points = 20;
  result.exercises[0].max_points = 30;
  result.extra_credit_counted = 3;
  result.remarks = {"3 of your points count"};
  const std::string total = "<strong>23</strong> of 30 points, 3 of them extra credit";
  for (const std::string& page : {student_page(result), staff_page(result)}) {
    EXPECT_EQ(times(page, total), 1U);
    EXPECT_EQ(times(page, "3 of your points count"), 1U);
  }
  EXPECT_TRUE(says(student_text(result), "3 of your points count"));
  EXPECT_EQ(nlohmann::json::parse(student_json(result)).at("score"), 23);
}

TEST(SubmissionPage, CountsExtraCreditWithoutAZeroToReach) {
  SubmissionResult result = two_exercises();
  result.exercises.erase(result.exercises.begin());
  result.exercises[0].extra_credit = true;
  result.exercises[0].points = 15;
  result.exercises[0].max_points = 24;
  const std::string page = student_page(result);
  EXPECT_EQ(times(page, "<strong>15</strong> points of extra credit</p>"), 1U);
  EXPECT_EQ(times(page, "of 0"), 0U);
}

TEST(SubmissionPage, ShowsWordsOfTheStaffBesideTheLine) {
  SubmissionResult result = two_exercises();
  result.exercises[0].file = "conj_grad.cpp";
  result.exercises[0].source = "the whole file";
  result.exercises[0].said = {{result.exercises[0].id + ":17", "x < <b>", "The staff say: <script>"},
                              {result.exercises[0].id + ".1", "", "You asked: a\nb"}};
  for (const std::string& page : {student_page(result), staff_page(result)}) {
    EXPECT_EQ(times(page,
                    "conj_grad.cpp, line 17: <pre>x &lt; &lt;b&gt;</pre><p>The staff say: "
                    "&lt;script&gt;</p>"),
              1U);
    EXPECT_EQ(times(page, result.exercises[0].id + ".1 " + result.exercises[0].cases[0].name +
                              ": <p>You asked: a\nb</p>"),
              1U);
  }
  EXPECT_EQ(times(student_page(result), "the whole file"), 0U) << "it is the student's own";
  for (const std::string& text : {student_text(result), student_json(result)})
    EXPECT_GE(times(text, "conj_grad.cpp, line 17: x < <b>"), 1U) << text;
}

TEST(SubmissionPage, SaysWhichPointsByHandAreMissing) {
  SubmissionResult result = two_exercises();
  result.exercises.push_back(
      {.id = "oral", .title = "Oral examination", .status = Status::not_given, .max_points = 10});
  const std::string missing = "Oral examination is not given yet";
  EXPECT_EQ(times(student_page(result), "Not final: " + missing), 1U);
  EXPECT_EQ(times(first_lines(result), ", not final: " + missing), 1U);
  EXPECT_EQ(in_short(result.exercises.back()), "");
  EXPECT_TRUE(says(grades_csv({result}, {}), ",,not given yet,"));
  std::ostringstream table;
  print_table(table, {result, result});
  EXPECT_TRUE(says(table.str(), "NOT FINAL, 2 of 2: " + missing + "\n"));
  EXPECT_FALSE(says(table.str(), "nan"));
  EXPECT_TRUE(exercise_statistics({result}).back().points.empty()) << "it is in no mean";
  result.exercises.back().status = Status::given;
  EXPECT_EQ(times(student_page(result), "Not final"), 0U);
  EXPECT_EQ(in_short(result.exercises.back()), "0");
  result.exercises.back().points = 7;
  EXPECT_EQ(in_short(result.exercises.back()), "7");
}

}  // namespace
}  // namespace grader::report
