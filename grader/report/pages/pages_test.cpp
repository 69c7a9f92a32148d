// STAFF ONLY. Tests that pages show the results, and escape texts of strangers.
#include "grader/report/pages/pages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "grader/report/facts/picture_files.h"
#include "grader/report/facts/sample_results.h"
#include "grader/report/facts/student_view.h"
#include "grader/report/points_files.h"
#include "grader/report/results_json.h"
#include "hair/io/files/base64.h"
#include "hair/io/plot/readable.h"
#include "hair/io/plot/test_parsed.h"
#include "solver/test_refusal.h"

namespace grader::inline report {
namespace {

using tests::says;

using namespace std::string_literals;
// This has markup, quotes, a NUL, invalid UTF-8, a terminal's colours, the end of a CDATA section, a formula.
const std::string hostile =
    "=1+1 <script>alert(1)</script> \"quoted' &amp; ]]>\0\x01\xff\xc3\x28 \x1b[31mred\n--><img src=x "
    "onerror=y>"s;

void expect_clean(const std::string& output) {
  EXPECT_EQ(output, hair::valid_utf8(output));
  for (const char c : output) {
    EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t' || c == '\r')
        << static_cast<int>(c);
  }
}

std::vector<SubmissionResult> without_pictures(int size) {
  std::vector<SubmissionResult> results = sample_class(size);
  for (SubmissionResult& result : results)
    for (ExerciseResult& exercise : result.exercises) exercise.pictures.clear();
  return results;
}

TEST(Pages, HostileTextBecomesNoMarkup) {
  const SubmissionResult result = submission_full_of(hostile);
  for (const std::string& page : {student_page(result), staff_page(result), class_page({result})}) {
    EXPECT_EQ(times(page, "<script>alert"), 0u);
    EXPECT_EQ(times(page, "<img src=x"), 0u);
    EXPECT_GT(times(page, "&lt;script&gt;alert(1)&lt;/script&gt; &quot;quoted&#39; &amp;amp; ]]&gt;"), 0u);
    expect_clean(page);
  }
}

TEST(Pages, OfTheClassListWhatTheClockEnded) {
  std::vector<SubmissionResult> results = class_of_ten_exercises(3);
  EXPECT_EQ(times(class_page(results), "ended by the clock"), 0U);
  results[1].ended_by_the_clock = {"S1", "H4"};
  const std::string page = class_page(results);
  EXPECT_EQ(times(page, "not final: ended by the clock, grade again"), 1U);
  EXPECT_EQ(times(page, results[1].name + "</a>: S1, H4</li>"), 1U);
}

// Every element must be closed, in order: a browser would repair a page silently.
TEST(Pages, AStrictParserReadsThem) {
  std::vector<SubmissionResult> results = class_of_ten_exercises(30);
  results.push_back(submission_full_of(hostile));
  results[1].isolation = Isolation::none;
  results[2].images = false;
  const ComparedPair pair{"<x>.png", 8, 8, {0.1, 0.2, 0.3, false}};
  const ComparedPair uncompared{.name = "<y>.png", .distance = {}, .obstacle = "<cut> off & \"small\""};
  const Comparison comparison{"a", "b", {uncompared, pair}, {"only here.png"}, {"only there.png"}};
  std::vector<std::string> pages = {class_page({}), class_page(results),
                                    comparison_page(comparison, {{pair, "first", "second", "heat"}})};
  for (const SubmissionResult& result : results) {
    pages.push_back(student_page(result));
    pages.push_back(staff_page(result));
  }
  for (const std::string& page : pages) EXPECT_NO_THROW(hair::plot::parse_page(page)) << page.substr(0, 2000);
}

TEST(Pages, HostileTextKeepsTheGradebookWellFormed) {
  const SubmissionResult result = submission_full_of(hostile);
  const std::string junit = junit_xml({result});
  EXPECT_NO_THROW(hair::plot::parse(junit));
  expect_clean(junit);
  EXPECT_EQ(times(junit, "<script"), 0u);
  EXPECT_EQ(times(junit, "\"") % 2, 0u);
  expect_clean(student_json(result));
  SubmissionResult without_cases = result;  // then the compiler's messages are there
  without_cases.exercises[0].cases.clear();
  const auto json = nlohmann::json::parse(student_json(without_cases));
  EXPECT_TRUE(says(json.at("tests").at(0).at("output").get<std::string>(), "<script>"));
}

TEST(Pages, LoadNothingAndRunNothingOfTheirText) {
  const std::vector<SubmissionResult> results = sample_class(30);
  const std::string student = student_page(results[1]);
  for (const std::string& page : {student, staff_page(results[1]), class_page(results)}) {
    for (const char* outside : {"http:", "https:", "@import", "url("})
      EXPECT_EQ(times(page, outside), 0u) << outside;
    const bool alone = page == student;
    const std::string folder = page == class_page(results) ? "staff/pictures/" : "pictures/";
    EXPECT_EQ(times(page, alone ? "default-src &#39;none&#39;; img-src data:;"
                                : "default-src &#39;none&#39;; img-src &#39;self&#39; file:;"),
              1u);
    EXPECT_GT(times(page, "src="), 0u);
    EXPECT_EQ(times(page, "src="), times(page, alone ? "src=\"data:image/png;base64," : "src=\"" + folder));
    EXPECT_EQ(times(page, "<html lang=\"en\">"), 1u);
    EXPECT_EQ(times(page, "<title>"), 1u);
    EXPECT_EQ(times(page, "<section"), times(page, "</section>"));
    EXPECT_EQ(times(page, "<table"), times(page, "</table>"));
  }
  EXPECT_EQ(times(student, "<script"), 1u) << "one that looks closer at pictures that differ";
  EXPECT_EQ(times(staff_page(results[1]) + student_page(results[0]), "<script"), 0u);
}

TEST(Pages, StudentsSeeNothingOfTheStaffs) {
  SubmissionResult result = sample_class(1).front();
  result.exercises[0].staff_log = "STAFFSECRET";
  result.exercises[0].cases[0].detail = "STAFFSECRET";
  result.fingerprint = "STAFFSECRET";
  result.exercises[1].cases.clear();
  result.exercises[1].status = Status::does_not_compile;
  result.exercises[1].compiler_messages = "yourline";
  result.exercises[1].staff_log = "STAFFSECRET";
  EXPECT_EQ(times(student_page(result), "STAFFSECRET"), 0u);
  EXPECT_EQ(times(student_json(result), "STAFFSECRET"), 0u);
  EXPECT_EQ(times(student_json(result), "yourline"), 1u);
  EXPECT_EQ(times(student_page(result), "yourline"), 1u);
  EXPECT_EQ(times(class_page({result}) + grades_csv({result}) + junit_xml({result}), "STAFFSECRET"), 0u);
  EXPECT_EQ(times(student_page(result), "staff"), 0u);
  EXPECT_EQ(times(class_page({for_student(result)}, {.is_public = true}), "staff"), 0u);
  EXPECT_GE(times(staff_page(result), "STAFFSECRET"), 3u);
}

TEST(Pages, WithoutASandboxOrPicturesEveryPageSaysSo) {
  const struct {
    void (*change)(SubmissionResult& result);
    const char *words, *of_junit, *cells;
  } rows[] = {
      {[](SubmissionResult& result) { result.isolation = Isolation::none; }, "Graded without a sandbox",
       "Graded without a sandbox", ",no,"},
      {[](SubmissionResult& result) { result.images = false; }, "Graded without pictures",
       "graded without pictures", ",yes,no,"},
  };
  for (const auto& [change, words, of_junit, cells] : rows) {
    std::vector<SubmissionResult> results = sample_class(2);
    EXPECT_EQ(times(class_page(results) + student_page(results[1]) + staff_page(results[1]) +
                        student_json(results[1]) + junit_xml(results),
                    std::string(words).substr(1)),
              0u);
    change(results[1]);
    for (const std::string& page :
         {class_page(results), student_page(results[1]), staff_page(results[1]), student_json(results[1])})
      EXPECT_EQ(times(page, words), 1u) << words;
    EXPECT_EQ(times(student_page(results[0]), words), 0u);
    EXPECT_EQ(times(junit_xml(results), of_junit), 1u);
    EXPECT_EQ(times(grades_csv(results), cells), 1u);
  }
}

TEST(Pages, ShowAMomentsThreePicturesWithTheirDistancesAndInWords) {
  SubmissionResult result = without_pictures(1).front();
  result.exercises[1].pictures = {{"0.50 s", 0.0123, 0.0456, "theirs", "ours", "heat"}};
  for (const std::string& page : {student_page(result), staff_page(result)}) {
    for (const char* bytes : {"theirs", "ours", "heat"})
      EXPECT_EQ(times(page, "base64," + hair::base64(bytes) + "\"") +
                    times(page, "src=\"pictures/" + picture_name(bytes) + "\""),
                1u)
          << bytes;
    EXPECT_EQ(times(page, "<img"), 3u);
    EXPECT_EQ(times(page, " at 0.50 s\""), 3u);
    for (const char* words : {"0.0123", "0.0456", "<details open=\"\">"})
      EXPECT_GE(times(page, words), 1u) << words;
  }
}

TEST(Pages, TheSamePictureIsShownOnce) {
  SubmissionResult result = without_pictures(1).front();
  result.exercises[1].pictures = {sample_picture("0.50 s", 0)};
  const std::string page = student_page(result);
  EXPECT_EQ(times(page, "<img"), 1u);
  EXPECT_EQ(times(page, "the same, pixel for pixel"), 1u);
  EXPECT_EQ(times(page, "<details><summary>The whole run in pictures"), 1u);
}

TEST(Pages, TheClassIsSortedByItsWorstPictures) {
  std::vector<SubmissionResult> results = without_pictures(4);
  const PictureResult near = sample_picture("0.50 s", 1), far = sample_picture("1.00 s", 40),
                      same = sample_picture("2.00 s", 0);
  results[0].exercises[2].pictures = {same, near};
  results[1].exercises[1].pictures = {same};
  results[2].exercises[0].pictures = {near, far, near};
  const std::string page = class_page(results);
  const std::string section = page.substr(page.find("<section id=\"pictures\">"));
  const std::string rows = section.substr(0, section.find("</section>"));
  EXPECT_EQ(times(rows, "<tr><th scope=\"row\">"), 2u);
  const std::size_t first = rows.find("carol.html#S1"), second = rows.find("alice.html#P1");
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
  EXPECT_EQ(times(rows, "S1 at 1.00 s"), 1u + 3);
  EXPECT_EQ(times(rows, "in all pictures: 1. Without pictures: 1."), 1u);
  EXPECT_EQ(times(rows, "<img"), 6u);
}

// A run that stays at its start and ends at once looks like the reference's in its first picture.
TEST(Pages, ARunThatBreaksOffIsTheWorst) {
  std::vector<SubmissionResult> results = without_pictures(3);
  const CaseResult broken{kRunTitle, Status::crashed};
  results[0].exercises[0].pictures = {sample_picture("1.00 s", 40)};
  results[1].exercises[1].pictures = {sample_picture("0.00 s", 0)};
  results[1].exercises[1].cases.push_back(broken);
  results[2].exercises[2].cases.push_back(broken);
  EXPECT_TRUE(run_breaks_off(results[1].exercises[1]));
  const std::string page = class_page(results);
  const std::string section = page.substr(page.find("<section id=\"pictures\">"));
  const std::string rows = section.substr(0, section.find("</section>"));
  EXPECT_EQ(times(rows, ">breaks off<"), 2u);
  EXPECT_EQ(times(rows, "in all pictures: 0. Without pictures: 0."), 1u);
  EXPECT_LT(rows.find("bob.html"), rows.find("alice.html"));
  EXPECT_LT(rows.find("carol.html"), rows.find("alice.html"));

  // A run breaks off even if a picture differs, too, and a stub has no run.
  results[1].exercises[1].pictures[0].flip = 0.001;
  EXPECT_TRUE(run_breaks_off(results[1].exercises[1]));
  const std::string again = class_page(results);
  EXPECT_EQ(times(again, ">breaks off<"), 2u);
  EXPECT_LT(again.rfind("bob.html"), again.rfind("alice.html"));
  results[2].exercises[2].cases.back().status = Status::not_implemented;
  EXPECT_FALSE(run_breaks_off(results[2].exercises[2]));
  // A run with all pictures does not break off, however far they are, unless the last one says so.
  results[1].exercises[1].pictures.assign(kRunPictures, sample_picture("1.00 s", 40));
  EXPECT_FALSE(run_breaks_off(results[1].exercises[1]));
  results[1].exercises[1].pictures.back().breaks_off = true;
  EXPECT_TRUE(run_breaks_off(results[1].exercises[1]));
  EXPECT_TRUE(says(student_page(results[1]), "1.00 s, the last moment that can be drawn"));
}

// Pictures before the break may be like the reference's: their distance means nothing.
TEST(Pages, ARunThatBreaksOffIsOpenAndHasNoDistance) {
  SubmissionResult result = without_pictures(1).front();
  const CaseResult broken{kRunTitle, Status::crashed};
  result.exercises[0].cases.push_back(broken);
  for (const double flip : {0.0, 0.5}) {
    result.exercises[0].pictures = {sample_picture("0.00 s", 0)};
    result.exercises[0].pictures[0].flip = flip;
    for (const std::string& page : {student_page(result), staff_page(result)}) {
      EXPECT_EQ(
          times(page, "<details open=\"\"><summary>The whole run in pictures, until it breaks off</summary>"),
          1u);
      EXPECT_EQ(times(page, "FLIP up to"), 0u);
    }
  }
}

// A class page of a thousand pictures would load 60 MB.
TEST(Pages, TheClassShowsPicturesOfTheWorstTwentyAlone) {
  std::vector<SubmissionResult> results = sample_class(30);
  const PictureResult far = sample_picture("1.00 s", 40);
  for (SubmissionResult& result : results) result.exercises[0].pictures = {far};
  EXPECT_EQ(times(class_page(results), "<img"), 3u * 20);
}

// Both hand-ins have the share of a tenth.
TEST(CourseTotals, HaveExtraCreditUpToTheSharesOfAllHandIns) {
  using Cell = CourseTable::Cell;
  struct Row {
    std::optional<Cell> first, only_extra;
    double total;
  };
  const CourseTable course{
      .hand_ins = {{"first", "first", 0.1, 1, 100}, {"only extra", "only_extra", 0.1, 1, 0}}, .rows = {}};
  for (const Row& row : {Row{Cell{70, 100, 0}, {}, 70}, Row{Cell{70, 100, 10}, Cell{5, 0, 5}, 70},
                         Row{Cell{70, 100, 4}, Cell{5, 0, 5}, 75}, Row{Cell{98, 100, 0}, Cell{5, 0, 5}, 100},
                         Row{{}, Cell{15, 0, 15}, 10}}) {
    const Cell total = course.total({"alice", {row.first, row.only_extra}});
    EXPECT_EQ(total.points, row.total);
    EXPECT_EQ(total.max_points, 100);
  }
  const CourseTable all_extra{.hand_ins = {{"only extra", "only_extra", 0.1, 1, 0}}, .rows = {}};
  EXPECT_EQ(all_extra.total({"alice", {Cell{15, 0, 15}}}).points, 15);
}

TEST(Pages, AnEmptyClassIsAPage) {
  EXPECT_GE(times(class_page({}), "0 people"), 1u);
}

TEST(StudentJson, HasOneTestForAnExerciseThatPassesWholeAndNumbersCategoriesOfOthers) {
  const auto numbers = [](const SubmissionResult& result) {
    std::string all;
    const auto json = nlohmann::json::parse(student_json(result));
    for (const auto& test : json.at("tests")) all += test.at("number").get<std::string>() + " ";
    return all;
  };
  const std::vector<SubmissionResult> results = class_with_decisions();
  EXPECT_EQ(numbers(results[0]), "S1 S2 P1 ") << "the last one is excused";
  EXPECT_EQ(numbers(results[2]), "S1 S2.1 S2.2 S2.3 S2.4 S2.5 S2.6 P1.1 P1.2 P1.3 P1.4 P1.5 P1.6 ");
}

TEST(GradesCsv, QuotesAndNeutralisesCells) {
  for (const char* formula : {"=1+1", "+a", "-a", "@SUM(A1)", "\t=1", "\r=1", "\n=1"}) {
    const std::string csv = grades_csv({submission_full_of(formula)});
    const std::string text = csv.substr(csv.find("wrong,") + 6);
    EXPECT_TRUE(text.starts_with("\u2060") || text.starts_with("\"\u2060")) << text;
  }
  const std::string csv = grades_csv({submission_full_of("a \"b\", c\nd")});
  EXPECT_TRUE(says(csv, ",\"a \"\"b\"\", c\nd\",\r\n"));
}

TEST(GradesCsv, HasALineASubmissionAndSameColumnsInEach) {
  std::vector<SubmissionResult> results = sample_class(3);
  results[0].exercises.pop_back();
  EXPECT_EQ(grades_csv(results).substr(0, grades_csv(results).find('\r')),
            "submission,total,of,sandbox,pictures,S1,S1 status,S2,S2 status,P1,P1 status,note,decided");
  std::string csv = grades_csv(results);
  EXPECT_EQ(times(csv, "\r\n"), 4u);
  EXPECT_EQ(times(csv, ","), 4u * 12);
  EXPECT_TRUE(says(csv, "alice,50,50,yes,yes,30,passed,20,passed,,,,\r\n"));
}

TEST(GradesCsv, HasALineAPersonWithARoster) {
  const std::vector<SubmissionResult> results = sample_class(2);
  const std::vector<ClassLine> people{{results[0].name, "Jörg, J.", "1", "j@u.de", "A", ""},
                                      {results[0].name, "=1+1", "2", "", "", "its id is on no roster"},
                                      {"", "Zoë", "007", "", "B", "nothing handed in"}};
  const std::string csv = grades_csv(results, people);
  EXPECT_EQ(times(csv, "\r\n"), 5u);
  EXPECT_TRUE(says(csv, ",\"Jörg, J.\",1,j@u.de,A,\r\n"));
  EXPECT_TRUE(says(csv, ",\u2060=1+1,2,,,its id is on no roster\r\n"));
  EXPECT_TRUE(says(csv, "\r\n,,,,,,,,,,,,,Zoë,007,,B,nothing handed in\r\n"));
  EXPECT_TRUE(says(csv, "\r\n" + results[1].name + ","));
}

TEST(GradesCsv, HasDecisions) {
  const std::string csv = grades_csv(class_with_decisions());
  for (const char* line : {"alice,50,50,yes,yes,30,passed,20,passed,,excused,,excuse P1\r\n",
                           ",20,partly,10,partly,2.5,partly,,\"points S1.2, comment\"\r\n",
                           "\r\ndave,,0,yes,yes,,excused,,excused,,excused,,excuse\r\n"})
    EXPECT_TRUE(says(csv, line));
}

TEST(ClassPage, ShowsDecisionsAndConflictsFirst) {
  const std::vector<SubmissionResult> results = class_with_decisions();
  const std::string page = class_page(results);
  expect_in_order(
      page,
      {"<strong>39.25</strong> of 50 points on average, median 39.25, 4 people, 2 of them excused",
       "<h2>Worth a look</h2>\n<details><summary><span class=\"badge bad\">conflict", "</span> 1</summary>",
       "ada set S2 to 16, and now it is 10</li>", ">50</strong>", ">exc</a>",
       "title=\"excuse P1: ill\"><a href=\"staff/alice.html#P1\">excuse P1</a>",
       "title=\"S1: partly; a person set points\">20*</a>",
       "title=\"points S1.2: 10 (computed: 5): &lt;b&gt;\"><a href=\"staff/bob.html#S1\">points S1.2</a>",
       ">comment</a>", ">16*</a>",
       "<span class=\"badge bad\" title=\"points S2: 16\"><a href=\"staff/carol.html#S2\">conflict: points "
       "S2</a>",
       "<strong>exc</strong>",
       "<td class=\"number\">26.67</td><td class=\"number\">30</td><td class=\"number\">30</td><td "
       "class=\"number\">2 of 3</td>"});
  EXPECT_EQ(times(page, badge(Status::crashed).text), 0u) << "a person looked at the only one";
  EXPECT_NO_THROW(hair::plot::parse(page));
  EXPECT_EQ(times(staff_page(results[2]), "<p class=\"stamp\">ada set S2"), 1u);
  EXPECT_EQ(times(student_page(results[2]), "ada"), 0u) << "the conflict is the staff's";
  EXPECT_EQ(times(class_page(sample_class(4)), "Decided"), 0u);
}

TEST(ClassPage, FoldsCategoriesButForTheTenHardest) {
  const std::string page = class_page(class_of_ten_exercises(30));
  EXPECT_EQ(times(page, "Show all 60 categories</label>"), 1u);
  EXPECT_EQ(times(page, "<tr class=\"more\">"), 50u);
  EXPECT_EQ(times(class_page({sample_class(1)}), "class=\"more\""), 8u) << "18 categories";
}

TEST(ClassPage, LeadsToPeopleWhoFailAlike) {
  const std::vector<SubmissionResult> results = class_of_ten_exercises(30);
  const std::string page = class_page(results), alike = "id=\"alike\"";
  EXPECT_LT(page.find(alike), page.find("id=\"categories\""));
  const std::string list =
      page.substr(page.find(alike), page.find("</section>", page.find(alike)) - page.find(alike));
  EXPECT_GT(times(list, "<a href=\"staff/"), 2u) << list;
  EXPECT_EQ(times(list, "<a "), times(list, "</a>"));
}

TEST(ClassPage, SaysWhoIsMissingAndWhoIsOnNoRoster) {
  const std::vector<SubmissionResult> results = sample_class(2);
  const std::string page =
      class_page(results, {.people = {{results[0].name, "<b>J", "1", "", "A", "its id is on no roster"},
                                      {"", "Zoë", "007", "", "B", "nothing handed in"},
                                      {results[1].name, "Ann", "3", "", "A", ""}}});
  EXPECT_TRUE(says(page, "nothing handed in</span> 1</summary>"));
  EXPECT_TRUE(says(page, "<li>Zoë <span class=\"quiet\">007</span></li>"));
  EXPECT_TRUE(says(page, "on no roster</span> 1</summary>"));
  EXPECT_TRUE(says(page, "&lt;b&gt;J</a>"));
  EXPECT_EQ(times(page, "Ann"), 0u);
  EXPECT_EQ(times(class_page(results), "id=\"people\""), 0u);
}

TEST(ClassPage, ListsFilesThatReachedNoHandIn) {
  using enum Accounted::As;
  const std::vector<SubmissionResult> results = sample_class(2);
  std::vector<Accounted> listed{{"c.zip/index.html", made, "is the system's", ""},
                                {"c.zip/<b>.cpp", left_over, "belongs to nobody", ""},
                                {"c.zip/1/a.zip", older, "a newer one counts", "alice"},
                                {"", notice, "c.zip/2: <i> stayed shut", "bob"}};
  std::string page = class_page(results, {.listed = listed});
  EXPECT_EQ(
      times(page,
            "<tr><th scope=\"row\">c.zip/&lt;b&gt;.cpp</th><td>nobody&#39;s</td><td>belongs to nobody</td>"),
      1u);
  EXPECT_EQ(times(page, "<tr><th scope=\"row\">c.zip/1/a.zip</th><td>alice</td><td>a newer one counts</td>"),
            1u);
  EXPECT_EQ(times(page, "<li>c.zip/2: &lt;i&gt; stayed shut</li>"), 1u);
  EXPECT_EQ(times(page, "c.zip/index.html"), 0u);
  EXPECT_EQ(times(page, "<details open="), 3u);
  EXPECT_NO_THROW(hair::plot::parse(page));
  listed.insert(listed.end(), 10, listed[1]);
  page = class_page(results, {.listed = listed});
  EXPECT_EQ(times(page, "<details open="), 2u) << "a long list is folded";
  EXPECT_EQ(times(page, "not graded</span> 11</summary>"), 1u);
  EXPECT_EQ(times(class_page(results, {.listed = {listed[0]}}), "id=\"left-over\""), 0u);
}

TEST(ClassPage, SaysWhoWasLateAndWhatItCost) {
  const std::vector<SubmissionResult> results = sample_class(4);
  ClassFacts facts{.late = {{"alice", {"2025-03-05 10:00:00", 1, 0, 1.5}},
                            {"bob", {"2025-03-04 10:00:00", 0, 0, 0}},
                            {"carol", {"2025-03-09 10:00:00", 5, 2, 12}},
                            {"dave", {}}}};
  EXPECT_EQ(times(class_page(results, facts), "id=\"late\""), 0u) << "nothing is due";
  facts.due = "2025-03-04 23:59";
  const std::string page = class_page(results, facts);
  const std::size_t first = page.find(
      "carol</a></th><td>2025-03-09 10:00:00</td><td class=\"number\">5 days</td><td "
      "class=\"number\">2 days</td><td class=\"number\">12</td>");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(page.find("alice</a></th><td>2025-03-05 10:00:00</td><td class=\"number\">1 day</td><td "
                      "class=\"number\"></td><td class=\"number\">1.5</td>",
                      first),
            std::string::npos)
      << "the latest first";
  EXPECT_EQ(times(page, "2025-03-04 10:00:00"), 0u);
  EXPECT_EQ(times(page, "Nobody knows when 1 of 4 were handed in"), 1u);
  EXPECT_NO_THROW(hair::plot::parse(page));
  facts.late.erase("alice");
  facts.late.erase("carol");
  EXPECT_EQ(times(class_page(results, facts), "Nobody is known to be late"), 1u);
}

TEST(ClassPage, SaysWhoWasMarkedLateWhereNoTimeSaysIt) {
  const std::vector<SubmissionResult> results = sample_class(3);
  Lateness marked, in_time{"2025-03-04 10:00:00"};
  marked.marked = in_time.marked = true;
  ClassFacts facts{.late = {{"alice", marked}, {"bob", in_time}, {"carol", {}}}};
  const auto row = [](const std::string& name, const std::string& time) {
    return name + "</a></th><td>" + time + "</td><td colspan=\"3\">marked late by Canvas</td>";
  };
  std::string page = class_page(results, facts);
  EXPECT_EQ(times(page, row("alice", "")), 1u);
  EXPECT_EQ(times(page, row("bob", "2025-03-04 10:00:00")), 1u) << "nobody knows when it was due";
  EXPECT_EQ(times(page, "marked late by"), 2u);
  EXPECT_EQ(times(page, "has no due date"), 1u);
  EXPECT_EQ(times(page, "Nobody"), 0u);
  EXPECT_NO_THROW(hair::plot::parse(page));
  facts.due = "2025-03-04 23:59";
  page = class_page(results, facts);
  EXPECT_EQ(times(page, row("alice", "")), 1u);
  EXPECT_EQ(times(page, "marked late by"), 1u) << "the time says more than the mark";
  EXPECT_EQ(times(page, "Due 2025-03-04 23:59"), 1u);
}

TEST(ClassPage, SaysThatARunIsNotWhole) {
  const auto said = [](const LastRun& run) { return class_page(sample_class(2), {.run = run}); };
  LastRun run{.wall_seconds = 9, .graded = 2, .jobs = 1};
  EXPECT_EQ(times(said(run), "--resume"), 0u) << "of a record that knows no more";
  run.began = "2025-03-04 10:15:22";
  run.asked = 180;
  run.done = 12;
  EXPECT_EQ(times(said(run), "began at 2025-03-04 10:15:22 (UTC) and has not ended: 12 of 180 hand-ins"), 1u);
  EXPECT_NO_THROW(hair::plot::parse(said(run)));
  run.ended = "2025-03-04 10:20:00";
  EXPECT_EQ(
      times(said(run), "12 of 180 hand-ins were done when the run was interrupted at 2025-03-04 10:20:00"),
      1u);
  run.done = 180;
  EXPECT_EQ(times(said(run), "--resume"), 0u);
  run.ended = "";
  EXPECT_EQ(times(said(run), "has not ended: 180 of 180"), 1u);
}

TEST(Junit, CountsWhatItLists) {
  const std::string junit = junit_xml(sample_class(10));
  EXPECT_EQ(times(junit, "<testsuite "), 10u);
  EXPECT_EQ(times(junit, "<testcase "), times(junit, "classname="));
  for (const char* element : {"failure", "error", "skipped"}) {
    std::size_t stated = 0;
    const std::string attribute = std::string(" ") + element + (element[0] == 's' ? "=\"" : "s=\"");
    for (std::size_t at = junit.find(attribute); at != std::string::npos;
         at = junit.find(attribute, at + 1)) {
      stated += std::stoul(junit.substr(at + attribute.size()));
    }
    EXPECT_EQ(stated, times(junit, "<" + std::string(element) + " ")) << element;
    EXPECT_GT(stated, 0u) << element;
  }
}

}  // namespace
}  // namespace grader::report
