// STAFF ONLY. Tests that Blackboard's Grade Center gets its grades, and keeps all other bytes.
#include "grader/gradebook/filling.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/gradebook/importers.h"
#include "solver/test_refusal.h"

namespace grader::inline gradebook {
namespace {

using std::string;
using tests::says;

const string kLab = "Lab 3 [Total Pts: 10 Score] |664617";

Grade blackboard_grade(const string& login, double points) {
  return {.hand_in = "h_" + login,
          .owner = {.id = login},
          .system = "blackboard",
          .points = points,
          .max_points = 10,
          .entered = {"6"}};
}

string table(const std::vector<Cells>& rows, char separator, bool quoted) {
  string text;
  for (const Cells& row : rows) text += csv_line(row, separator, "\r\n", quoted);
  return text;
}

std::vector<Cells> grade_center(const string& so12, const string& jm07, const string& words = "") {
  return {{"Last Name", "First Name", "Username", "Student ID", kLab, "Feedback to Learner"},
          {"O'Brien", "Se\u00e1n", "so12", "00400123", so12, so12.empty() ? "" : "Points. First"},
          {"M\u00fcller", "J\u00f6rg", "jm07", "7", jm07, words},
          {"=1+1", "", "x", "8", "", ""}};
}

// A download has commas with quotes, or tabs in UTF-16.
TEST(BlackboardGradeCenter, IsFilledInInItsOwnForm) {
  const FillOptions options{.column = "", .first_lines = [](const string&) { return "Points. First"; }};
  for (const Encoding& encoding : {Encoding{"UTF-8", "\xef\xbb\xbf"}, Encoding{"UTF-16LE", "\xff\xfe"},
                                   Encoding{}, Encoding{"CP1252"}}) {
    const bool tabs = string(encoding.page) == "UTF-16LE";
    const auto file = [&](const std::vector<Cells>& rows) {
      return encoded(table(rows, tabs ? '\t' : ',', !tabs), encoding);
    };
    const Gradebook book =
        fill_blackboard(parse_csv(file(grade_center("Needs Grading", "3.00")), "gc.csv"),
                        {blackboard_grade("so12", 7.5), blackboard_grade("jm07", 3)}, options);
    EXPECT_EQ(book.csv, file(grade_center("7.5", "3", "Points. First"))) << encoding.page;
    EXPECT_EQ(book.written, 2u);
    EXPECT_TRUE(says(book, tabs ? "name it .xls" : "name it .csv"));
    EXPECT_TRUE(says(book, "never tried at a real Blackboard"));
  }
}

TEST(BlackboardGradeCenter, KeepsCellsThatAreNotOurs) {
  for (const char* cell : {"Needs Grading(7.00)", "In Progress", "Exempt", "8.00"}) {
    const string text = table(grade_center(cell, "6.00", "Well done."), ',', true);
    const Gradebook book = fill_blackboard(parse_csv(text, "gc.csv"),
                                           {blackboard_grade("so12", 7.5), blackboard_grade("jm07", 9)},
                                           {.first_lines = [](const string&) { return "Points"; }});
    EXPECT_EQ(book.csv, table(grade_center(cell, "9", "Well done."), ',', true));
    EXPECT_TRUE(says(book, "line 2: ") && says(book, cell)) << cell;
    EXPECT_TRUE(says(book, "line 3: \"Well done.\" stays, which a person entered"));
    EXPECT_FALSE(book.all_entered);
  }
}

TEST(BlackboardGradeCenter, RefusesColumnsThatItsImportWouldMakeAnew) {
  const auto refused = [](const string& titles, const string& wanted) {
    return tests::refusal<BadInput>([&] {
      fill_blackboard(parse_csv("Username\t" + titles + "\nso12\n", "gc.xls"), {blackboard_grade("so12", 1)},
                      {.column = wanted});
    });
  };
  struct Refused {
    const char *titles, *wanted, *why;
  };
  for (const Refused& one :
       {Refused{"Lab 3 [Total Pts: 10 Score]", "Lab 3 [Total Pts: 10 Score]",
                "ends with no number such as |664617"},
        {"Lab 3", "", "no title is as \"Lab 3 [Total Pts: 10 Score] |664617\""},
        {"Lab 3 [Total Pts: 10 Text] |1", "", "is no column of scores"},
        {"Lab 3 [Total Pts: 10 Letter] |1", "Lab 3", "is no column of scores"},
        {"Total [Total Pts: up to 10 Score] |1", "1", "is computed from others"},
        {"A [Total Pts: 10 Score] |1\tB [Total Pts: 10 Score] |2", "", "several columns have grades"},
        {"A [Total Pts: 10 Score] |1\tB", "Lab 4",
         "no column is \"Lab 4\"; give --column with one of \"A [Total"},
        {"A [Total Pts: 20 Score] |1", "", "is out of 20 points, and the grades are out of 10"}})
    EXPECT_TRUE(says(refused(one.titles, one.wanted), one.why));
  for (const char* wanted : {"", "Lab [1: 2]", "7", "|7"})
    EXPECT_EQ(refused("Lab [1: 2] [Total Pts: 10] |7", wanted), "") << wanted;
  EXPECT_TRUE(says(tests::refusal<BadInput>(
                       [] { fill_blackboard(parse_csv("User\t" + kLab + "\nso12\t\n", "gc.xls"), {}, {}); }),
                   "no title is Username"));
  EXPECT_TRUE(says(tests::refusal<BadInput>([] {
                     fill_blackboard(parse_csv("Username\t" + kLab + "\nso13\t\n", "gc.xls"),
                                     {blackboard_grade("so12", 1)}, {});
                   }),
                   "nobody who has a grade here is in it"));
}

}  // namespace
}  // namespace grader::gradebook
