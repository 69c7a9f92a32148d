// STAFF ONLY. Tests that rows for Brightspace and Autolab are imported, and plain rows have a warning.
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

Grade row_grade(const string& system, const Owner& owner, double points) {
  return {.hand_in = "h_" + owner.id,
          .owner = owner,
          .system = system,
          .points = points,
          .max_points = 10,
          .exercises = {{"S1", points - 1}, {"S2", 1}}};
}

TEST(BrightspaceRows, AreImportedIntoAnItemThatIsThere) {
  const Csv exported = parse_csv(
      "OrgDefinedId,Username,Last Name,Lab 3 Points Grade <Numeric MaxPoints:10 Weight:5>,End-of-Line "
      "Indicator\n"
      "#400123,#so12,O'Brien,,#\n#400124,#jm07,M,,#\n=4,#x,X,,#\n#5,#t,T,3,#\n",
      "e.csv");
  const Gradebook book = fill_brightspace(
      exported,
      {row_grade("brightspace", {"", "400123", ""}, 7.5), row_grade("brightspace", {"", "jm07", ""}, 11),
       row_grade("brightspace", {"", "x", ""}, 1), row_grade("brightspace", {"", "5", ""}, 1)},
      {});
  const Imported imported =
      import_into_brightspace(book.csv, {"Lab 3 Points Grade <Numeric MaxPoints:10 Weight:5>"});
  EXPECT_EQ(imported.scores, (Scores{{"#400123", "7.5"}, {"#400124", "11"}}));
  EXPECT_EQ(imported.refused, Cells{});
  EXPECT_EQ(imported.new_assignments, Cells{});
  EXPECT_TRUE(says(book, "line 3: 11 points are cut to 10"));
  EXPECT_TRUE(says(book, "line 4: h_x's grade is not entered: a spreadsheet would run the id"));
  EXPECT_TRUE(says(book, "line 5: \"3\" stays, which a person entered, and h_5's \"1\" is not entered"));
  EXPECT_FALSE(book.all_entered);
  EXPECT_THROW(fill_brightspace(exported, {row_grade("brightspace", {"", "6", ""}, 1)}, {}), BadInput);
  EXPECT_THROW(fill_brightspace(exported, {}, {.column = "Lab 4"}), BadInput);
  EXPECT_THROW(fill_brightspace(parse_csv("Username,x\na,1\n", "e.csv"), {}, {}), BadInput);
  EXPECT_THROW(fill_brightspace(parse_csv("Name,Lab Points Grade\na,1\n", "e.csv"), {}, {}), BadInput);
  EXPECT_NO_THROW(fill_brightspace(parse_csv("Username,A Points Grade,B Points Grade\na,1,2\n", "e.csv"), {},
                                   {.column = "B"}));
  EXPECT_THROW(
      fill_brightspace(parse_csv("Username,A Points Grade,B Points Grade\na,1,2\n", "e.csv"), {}, {}),
      BadInput);
}

TEST(AutolabRows, HaveNoTitlesAndAValueForEachProblem) {
  Grade excused = row_grade("autolab", {"", "c@u.de", ""}, 5);
  excused.excused = true;
  const Gradebook book = autolab_rows(
      {row_grade("autolab", {"", "b@u.de", ""}, 5.5), row_grade("folders", {"", "a", "a@u.de"}, 3), excused,
       row_grade("folders", {"", "x", ""}, 3), row_grade("autolab", {"", "=x@u.de", ""}, 3)},
      {"S2", "S1", "total", "H1"}, nullptr);
  const Imported imported = import_into_autolab(book.csv, 4);
  EXPECT_EQ(imported.scores,
            (Scores{{"a@u.de", "1|2|3||"}, {"b@u.de", "1|4.5|5.5||"}, {"c@u.de", "||||excused"}}));
  EXPECT_EQ(imported.refused, Cells{});
  EXPECT_TRUE(says(book, "h_x: has no e-mail address"));
  EXPECT_TRUE(says(book, "h_=x@u.de: a spreadsheet would run the e-mail address"));
  EXPECT_TRUE(says(book, "in the order of the lab's problems, which must be S2, S1, total, H1"));
}

TEST(PlainRows, SayThatNoImportIsConfirmed) {
  const Csv roster =
      parse_csv("First Name,Last Name,SID,Email\nSeán,O'Brien,1,so@u.ie\n-x,=y,2,b@u.de\n", "r.csv");
  const Gradebook book = plain_rows("gradescope", &roster, {row_grade("gradescope", {"", "1", ""}, 7.5)}, {});
  EXPECT_EQ(book.csv,
            "name,id,e-mail,points,of,status,no import by gradescope is confirmed: enter by hand\r\n"
            "Seán O'Brien,1,so@u.ie,7.5,10,graded,\r\n\u2060-x =y,2,b@u.de,,,no grade,\r\n");
  EXPECT_TRUE(says(book, "no import by gradescope is confirmed"));
  std::vector<Grade> to_come{row_grade("gradescope", {"", "1", ""}, 2),
                             row_grade("gradescope", {"", "2", ""}, 3)};
  for (Grade& one : to_come) one.not_final = "oral is not given yet";
  const Gradebook open = plain_rows("gradescope", &roster, to_come, {});
  EXPECT_TRUE(says(open, "h_1, h_2: are not final, since oral is not given yet"));
  EXPECT_NE(open.csv.find(",3,10,not final,"), string::npos) << open.csv;
  const Gradebook without =
      plain_rows("gradescope", nullptr, {row_grade("gradescope", {"A", "a1", ""}, 2)}, {});
  EXPECT_TRUE(says(without.csv, "A,a1,,2,10,graded,\r\n"));
}

}  // namespace
}  // namespace grader::gradebook
