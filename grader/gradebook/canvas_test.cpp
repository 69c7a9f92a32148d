// STAFF ONLY. Tests that Canvas's importer takes the filled cells, and that nothing else changes.
#include "grader/gradebook/filling.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/gradebook/importers.h"
#include "solver/test_refusal.h"

namespace grader::inline gradebook {
namespace {

using std::string;
using tests::says;
using Scores = std::map<string, string>;

const string kExport =
    "Student,ID,SIS Login ID,Section,\"Quiz, first (77)\",Lab 3 (8801),Final Score\n"
    ",,,,Manual Posting,,\n"
    "    Points Possible,,,,5,10,(read only)\n"
    "\"O'Brien, Seán\",4712,so12,Lab A,4.00,,80.0\n"
    "\"Müller-Lüdenscheidt, Jörg\",4711,jm07,Lab A,,7.50,\n"
    "\"Doe, Jane\",4713,jd,Lab B,,EX,\n"
    "\"Roe, Rick\",4714,rr,Lab B,,3.00,\n"
    "=1+1,4715,x,Lab B,,,\n";

Grade grade_of(const string& id, double points, double of = 10) {
  return {.hand_in = "hand_in_" + id,
          .owner = {"", id, ""},
          .system = "canvas",
          .points = points,
          .max_points = of,
          .entered = {"7.5"}};
}

Gradebook fill(const string& text, const std::vector<Grade>& grades, const FillOptions& options = {}) {
  return fill_canvas(parse_csv(text, "export.csv"), grades, options);
}

// Returns the scores that Canvas changes by the gradebook that is filled into its export.
Scores scores(const std::vector<Grade>& grades, FillOptions options = {}) {
  if (options.column.empty()) options.column = "8801";
  return import_into_canvas(fill(kExport, grades, options).csv, kExport, "8801").scores;
}

Grade excused(const string& id) {
  Grade grade = grade_of(id, 3);
  grade.excused = true;
  return grade;
}

string error_of(const string& text, const std::vector<Grade>& grades, const FillOptions& options = {}) {
  return tests::refusal<BadInput>([&] { fill(text, grades, options); });
}

TEST(CanvasGradebook, ImportsTheGradesAndNothingElse) {
  const std::vector<Grade> grades{grade_of("4712", 9.125), grade_of("4711", 0), grade_of("4713", 5),
                                  grade_of("4715", 10)};
  const Gradebook book = fill(kExport, grades, {.column = "8801"});
  const Imported imported = import_into_canvas(book.csv, kExport, "8801");
  EXPECT_EQ(imported.scores, (Scores{{"4712", "9.12"}, {"4711", "0"}, {"4715", "10"}}));
  EXPECT_EQ(imported.refused, Cells{});
  EXPECT_EQ(imported.new_assignments, Cells{});
  EXPECT_EQ(imported.new_people, Cells{});
  EXPECT_EQ(book.written, 3u);
  const std::size_t rows_of_titles = kExport.find("\"O'Brien");
  EXPECT_EQ(book.csv.substr(0, rows_of_titles), kExport.substr(0, rows_of_titles));
  EXPECT_TRUE(says(book, "line 6: hand_in_4713's grade is not entered: the column \"Lab 3 (8801)\" has EX"));
  EXPECT_TRUE(says(book, "1 person has no grade here, and their cells stay as they were: line "));
  for (const Csv::Row& row : parse_csv(book.csv, "x").rows)
    for (const string& cell : row.cells) EXPECT_FALSE(starts_formula(cell)) << cell;
}

TEST(CanvasGradebook, FindsTheColumnByNumberOrTitle) {
  for (const char* column : {"8801", "(8801)", "Lab 3", "Lab 3 (8801)"})
    EXPECT_EQ(scores({grade_of("4712", 1)}, {.column = column}), (Scores{{"4712", "1"}})) << column;
  EXPECT_EQ(error_of(kExport, {grade_of("4712", 1)}),
            "export.csv, line 1: has several assignments; give --column with one of \"Quiz, first (77)\", "
            "\"Lab 3 (8801)\"");
  EXPECT_EQ(error_of(kExport, {grade_of("4712", 1)}, {.column = "Lab 4"}),
            "export.csv, line 1: no column is \"Lab 4\"; give --column with one of \"Quiz, first (77)\", "
            "\"Lab 3 (8801)\"");
  const string one = "Student,ID,SIS Login ID,Section,Lab 3 (8801)\n\"O'Brien, Seán\",4712,so12,Lab A,\n";
  const Gradebook book = fill(one, {grade_of("4712", 1)});
  EXPECT_EQ(import_into_canvas(book.csv, one, "8801").scores, (Scores{{"4712", "1"}}));
  EXPECT_TRUE(says(book, "has no points possible"));
}

TEST(CanvasGradebook, ExcusedIsAWord) {
  EXPECT_EQ(scores({excused("4712")}), (Scores{{"4712", "EX"}}));
}

TEST(CanvasGradebook, SpreadsheetsMayHaveWrittenItAgain) {
  string semicolons;
  for (Csv::Row& row : parse_csv(kExport, "x").rows) {
    for (string& cell : row.cells)
      if (cell == "7.50" || cell == "4.00") cell[1] = ',';
    semicolons += csv_line(row.cells, ';', "\n");
  }
  const Gradebook book =
      fill("\xef\xbb\xbf" + semicolons, {grade_of("4712", 1234.5, 10)}, {.column = "8801"});
  EXPECT_EQ(import_into_canvas(book.csv, semicolons, "8801").scores, (Scores{{"4712", "1234.5"}}));
  EXPECT_TRUE(import_into_canvas(book.csv, semicolons, "8801").refused.empty());
  EXPECT_TRUE(says(book.csv, ";7.50;"));
  EXPECT_TRUE(says(book.csv, ";4.00;")) << "another assignment's: ";
  string tabs =
      "Student\tID\tSection\tx (1)\n    Points Possible\t\t\t10\n\"Doe, Jane\"\t1\tA\t\"1,234\"\n\"Roe, "
      "R\"\t2\tA\t\n";
  const Gradebook commas = fill(tabs, {grade_of("2", 7)});
  EXPECT_EQ(commas.csv,
            "Student,ID,Section,x (1)\n    Points Possible,,,10\n\"Doe, Jane\",1,A,\n\"Roe, R\",2,A,7\n");
  EXPECT_TRUE(says(commas, "line 3: Canvas would read 1,234 with a decimal comma"));
}

TEST(CanvasGradebook, AnotherMaximumIsNoAccident) {
  EXPECT_EQ(error_of(kExport, {grade_of("4712", 150, 200)}, {.column = "8801"}),
            "the column \"Lab 3 (8801)\": is out of 10 points, and the grades are out of 200; change it "
            "there, or give --scale for shares of its points");
  EXPECT_EQ(scores({grade_of("4712", 150, 200)}, {.scale = true}), (Scores{{"4712", "7.5"}}));
}

TEST(CanvasGradebook, NobodyGetsAnothersGrade) {
  const Gradebook book = fill(kExport,
                              {grade_of("4712", 1),
                               grade_of("4712", 2),
                               grade_of("9999", 3),
                               {.hand_in = "team",
                                .owner = {.name = "T",
                                          .id = "5",
                                          .email = "",
                                          .group = true,
                                          .members = {{"", "4711", ""}, {"", "4714", ""}}},
                                .system = "canvas",
                                .points = 4,
                                .max_points = 10,
                                .entered = {"2", "3", "7.5"}}},
                              {.column = "8801"});
  EXPECT_EQ(import_into_canvas(book.csv, kExport, "8801").scores, (Scores{{"4711", "4"}, {"4714", "4"}}));
  EXPECT_TRUE(says(book, "line 4: left as it is, for hand_in_4712 and hand_in_4712 are both this person's"));
  EXPECT_TRUE(says(book, "hand_in_9999: has no row in export.csv, its id 9999 is on no roster"));
}

TEST(CanvasGradebook, ScoresThatAPersonEnteredStay) {
  const Gradebook kept =
      fill(kExport, {grade_of("4714", 9), grade_of("4711", 8), grade_of("4712", 1)}, {.column = "8801"});
  EXPECT_EQ(import_into_canvas(kept.csv, kExport, "8801").scores, (Scores{{"4711", "8"}, {"4712", "1"}}));
  EXPECT_TRUE(says(kept,
                   "line 7: \"3.00\" stays, which a person entered, and hand_in_4714's \"9\" is not entered; "
                   "give --overwrite"));
  EXPECT_FALSE(kept.all_entered);
  EXPECT_EQ(kept.entered,
            (std::vector<std::pair<string, string>>{{"hand_in_4712", "1"}, {"hand_in_4711", "8"}}));
  const Gradebook same = fill(kExport, {grade_of("4714", 3)}, {.column = "8801"});
  EXPECT_EQ(same.written, 1u);
  EXPECT_TRUE(same.all_entered);
  EXPECT_EQ(scores({excused("4714")}), Scores{});
  EXPECT_EQ(scores({excused("4714")}, {.overwrite = true}), (Scores{{"4714", "EX"}}));
}

TEST(CanvasGradebook, APersonWithTwoRowsHasTheGradeInBoth) {
  const string titles = "Student,ID,SIS Login ID,Section,Lab 3 (8801)\n    Points Possible,,,,10\n";
  const string row = "\"Oh, Ann\",4712,ao,";
  const Gradebook book = fill(titles + row + "A,\n" + row + "B,7.5\n" + row + "B,9\n", {grade_of("4712", 5)});
  EXPECT_EQ(book.csv, titles + row + "A,5\n" + row + "B,5\n" + row + "B,9\n");
  EXPECT_TRUE(says(book, "line 5: \"9\" stays"));
  EXPECT_TRUE(says(error_of(titles + row + "A,\n\"Oh, Ann\",4712,other,B,\n", {grade_of("4712", 5)}),
                   "line 4: id 4712 is line 3's, too"));
}

TEST(CanvasGradebook, HandInsOfAnotherSystemComeByTheRoster) {
  const Roster roster(parse_csv("identifier,github_username,login\nx,SeanOB,so12\n", "roster.csv"));
  const Grade grade{
      .hand_in = "seanob", .owner = {"", "seanob", ""}, .system = "classroom", .points = 6, .max_points = 10};
  EXPECT_EQ(scores({grade}, {.roster = &roster}), (Scores{{"4712", "6"}}));
}

TEST(CanvasGradebook, UncertainRulesWarn) {
  const string final_lab = "Student,ID,Section,Final lab (1)\n    Points Possible,,,10\n\"Doe, J\",1,A,\n";
  EXPECT_TRUE(says(fill(final_lab, {grade_of("1", 5)}),
                   "not certain: Canvas was seen to ignore a column with \"final\""));
  const string complete =
      "Student,ID,Section,Lab (1),Seen (2)\n    Points Possible,,,10,1\n\"Doe, J\",1,A,,complete\n";
  EXPECT_TRUE(says(fill(complete, {grade_of("1", 5)}, {.column = "1"}),
                   "not certain: Canvas was seen to drop scores beside"));
}

TEST(CanvasGradebook, SaysWhatIsNoExport) {
  const std::vector<Grade> grades{grade_of("1", 5)};
  EXPECT_EQ(
      error_of(kExport, {grade_of("9", 5)}, {.column = "8801"}),
      "export.csv: nobody who has a grade here is in it (hand_in_9: its id 9 is on no roster); give the "
      "table of this course and assignment, or --roster with ids of both");
  for (const auto& [text, why] :
       {std::pair{"id,name\n1,A\n", "export.csv, line 1: is no gradebook of Canvas"},
        {"Student,ID,SIS Login ID,x (1)\nA,1,a,\n", "no title is Section"},
        {"Student,ID,Section,x\nA,1,a,\n", "has no assignment's column"},
        {"Student,ID,Section,x (1)\n    Points Possible,,,(read only)\nA,1,a,\n", "is read only"},
        {"Student,ID,Section,=x (1)\nA,1,a,\n", "would run the title \"=x (1)\""},
        {"Student,ID,Section,x (1)\nA,1,a,3,4\n", "line 2: has 5 cells, and there are 4 titles"}})
    EXPECT_TRUE(says(error_of(text, grades), why));
  EXPECT_TRUE(says(error_of("Student,ID,Section,x (1),x (1)\nA,1,a,,\n", grades, {.column = "1"}),
                   "several columns are \"1\""));
}

}  // namespace
}  // namespace grader::gradebook
