// STAFF ONLY. Tests that tables are read as systems and spreadsheets write them, and run no cell.
#include "grader/text/csv.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "solver/test_refusal.h"

namespace grader::inline text {
namespace {

using std::string, std::string_literals::operator""s;
using tests::says;

std::vector<Cells> cells_of(const Csv& table) {
  std::vector<Cells> rows;
  for (const Csv::Row& row : table.rows) rows.push_back(row.cells);
  return rows;
}

string error_of(const string& bytes) {
  return tests::refusal<BadInput>([&] { parse_csv(bytes, "r.csv"); });
}

TEST(Csv, ReadsEverySeparatorEndOfLineAndEncoding) {
  const std::vector<Cells> wanted{{"id", "name, or so", "x"}, {"007", "Jörg; \"J\"\nM\t", ""}};
  for (const char separator : {',', ';', '\t'})
    for (const char* end : {"\n", "\r\n"}) {
      string text;
      for (const Cells& row : wanted) text += csv_line(row, separator, end);
      SCOPED_TRACE(text);
      EXPECT_EQ(cells_of(parse_csv(text, "r.csv")), wanted);
      EXPECT_EQ(cells_of(parse_csv("\xef\xbb\xbf" + text, "r.csv")), wanted);
      for (const bool little : {true, false})
        for (const bool mark : {true, false}) {
          const string wide =
              encoded(text, {little ? "UTF-16LE" : "UTF-16BE", mark ? little ? "\xff\xfe" : "\xfe\xff" : ""});
          const Csv table = parse_csv(wide, "r.csv");
          EXPECT_EQ(cells_of(table), wanted);
          ASSERT_FALSE(table.said.empty());
          EXPECT_EQ(table.said[0], "r.csv: is read as UTF-16 ("s + (little ? "little" : "big") + "-endian)");
        }
    }
}

TEST(Csv, LettersOfUtf16BeyondItsFirstPlaneAreOne) {
  const string text =
      "\x61\0\x2c\0\xac\x20\x3d\xd8\x00\xde\n\0\x62\0\x2c\0\x3d\xd8\n\0"s;  // a, euro, a face; b, half a face
  const Csv table = parse_csv("\xff\xfe" + text, "r.csv");
  EXPECT_EQ(cells_of(table), (std::vector<Cells>{{"a", "€😀"}, {"b", "\ufffd"}}));
}

TEST(Csv, SaysItsSeparatorAndItsGuess) {
  EXPECT_EQ(parse_csv("a;b\n1,5;2\n", "r.csv").said, Cells{"r.csv: its separator is a semicolon"});
  EXPECT_EQ(parse_csv("a\tb\n1\t2\n", "r.csv").said, Cells{"r.csv: its separator is a tab"});
  EXPECT_EQ(parse_csv("\xef\xbb\xbf"
                      "a,b\n",
                      "r.csv")
                .said,
            Cells{"r.csv: a byte order mark is passed over"});
  const Csv western = parse_csv("id,name\n1,J\xf6rg \x80\n", "r.csv");
  EXPECT_EQ(western.rows[1].cells[1], "Jörg €");
  ASSERT_EQ(western.said.size(), 1u);
  EXPECT_TRUE(says(western.said[0], "Windows-1252, a guess"));
}

TEST(Csv, AFirstLineMayTellTheSeparator) {
  struct Told {
    string line, head, said;
  };
  for (const Told& told : {Told{"sep=;\r\n", "a;b,c\r\n", "a semicolon"},
                           {"SEP=;\n", "a;b,c\n", "a semicolon"},
                           {"\"sep=;\"\n", "a;b,c\n", "a semicolon"},
                           {"sep=\t\n", "a\tb,c\n", "a tab"},
                           {"sep=|\n", "a|b,c\n", "|"}}) {
    const Csv table = parse_csv(told.line + told.head, "r.csv");
    EXPECT_EQ(cells_of(table), (std::vector<Cells>{{"a", "b,c"}})) << told.line;
    EXPECT_EQ(place_of(table, table.rows[0]), "r.csv, line 2");
    EXPECT_EQ(table.said, Cells{"r.csv: its separator is " + told.said});
  }
  EXPECT_EQ(cells_of(parse_csv("sep=,\nid,name\n", "r.csv")), (std::vector<Cells>{{"id", "name"}}));
  EXPECT_EQ(cells_of(parse_csv("sep=more,x\n", "r.csv")), (std::vector<Cells>{{"sep=more", "x"}}));
}

TEST(Csv, GoesBackInItsEncoding) {
  for (const string& mark : {"\xff\xfe"s, "\xfe\xff"s, "\xef\xbb\xbf"s, ""s}) {
    const Encoding& encoding =
        parse_csv(mark + (mark.size() == 2 ? mark[0] == '\xff' ? "a\0"s : "\0a"s : "a"), "r.csv").encoding;
    const string bytes = encoded("J\u00f6rg \u20ac \U0001f600\n", encoding);
    EXPECT_TRUE(bytes.starts_with(mark));
    EXPECT_EQ(decoded(bytes, "r.csv").text, "J\u00f6rg \u20ac \U0001f600\n");
  }
  EXPECT_EQ(encoded("J\u00f6rg \u20ac \U0001f600", parse_csv("J\xf6rg,1\n", "r.csv").encoding),
            "J\xf6rg \x80 ?");
}

TEST(Csv, ASeparatorMayStandInCells) {
  EXPECT_EQ(cells_of(parse_csv("Student;ID\nDoe, Jane, Dr., Prof.;1\nRoe, R, R, R;2\n", "r.csv"))[1],
            (Cells{"Doe, Jane, Dr., Prof.", "1"}));
  EXPECT_EQ(cells_of(parse_csv("a, b, c;id\nx;1\n", "r.csv"))[1], (Cells{"x", "1"}));
  EXPECT_EQ(cells_of(parse_csv("name,mail\n\"a;b;c\",x\n", "r.csv"))[1], (Cells{"a;b;c", "x"}));
  EXPECT_EQ(cells_of(parse_csv("id\n1\n\n2\n", "r.csv")), (std::vector<Cells>{{"id"}, {"1"}, {"2"}}));
}

TEST(Csv, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of(""), "r.csv: is empty; a table with a row of titles is needed");
  EXPECT_EQ(error_of("\r\n\r\n"), "r.csv: is empty; a table with a row of titles is needed");
  EXPECT_EQ(error_of("id,name\n\n1,\"a\nb\n"), "r.csv, line 3: a quote begins here and never ends");
  EXPECT_EQ(error_of("id,name\n1,\"a\"b\n"),
            "r.csv, line 2: text stands between the end of a quote and the separator; a quote within a cell "
            "is two");
  EXPECT_EQ(error_of("id,name\n1,a\0b\n"s),
            "r.csv, line 2: a NUL byte is no text; save the table as CSV in UTF-8");
  EXPECT_EQ(error_of("\xff\xfe\0\0i\0\0\0"s), "r.csv: is UTF-32; save it as UTF-8");
  EXPECT_EQ(error_of("\xff\xfei\0d"s), "r.csv: is UTF-16 and ends within a letter; save it as UTF-8");
  EXPECT_EQ(
      error_of("id,name\n1,\x89\xf0\x82\xad\x81\n"),
      "r.csv: is neither UTF-8 nor UTF-16 nor Windows-1252, and names in it would be others; save it as "
      "UTF-8");
}

TEST(Csv, LinesWithinACellCount) {
  const Csv table = parse_csv("a,b\n\"x\ny\",1\n2,3\n", "t.csv");
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(place_of(table, table.rows[1]), "t.csv, line 2");
  EXPECT_EQ(place_of(table, table.rows[2]), "t.csv, line 4");
}

TEST(Csv, FindsAColumnOnce) {
  const Csv table = parse_csv("SIS Login ID, name ,Name 2,e,E\n", "r.csv");
  EXPECT_EQ(column_of(table, "sis login id"), 0u);
  EXPECT_EQ(column_of(table, "Name"), 1u);
  EXPECT_EQ(column_of(table, "Namen"), kNoColumn);
  EXPECT_THROW(column_of(table, "e"), BadInput);
}

// OWASP, "CSV Injection": = + - @, tab and carriage return in front, and their wide forms.
TEST(CsvWriter, NoCellStartsAFormula) {
  for (const char* cell : {"=1+1", "+1+1", "-1+1", "-a", "@SUM(A1)", "\t=1", "\r=1", "\n=1", " =1", "＝1",
                           "＠a", "-1,2,3", "\xc2\xa0=1", "\u3000=1", "+49 89 1"}) {
    EXPECT_TRUE(starts_formula(cell)) << cell;
    const Csv::Row row = parse_csv(csv_line({"a", cell}), "r.csv").rows[0];
    EXPECT_EQ(row.cells[1], string("\u2060") + cell);  // has no apostrophe, and nothing is lost
  }
  for (const char* cell :
       {"-1", "-0.5", "-7,5", "+3", "-10%", "-", "a=1", "", "'=1", "12", "a@b.de", "\u2060=1"}) {
    EXPECT_FALSE(starts_formula(cell)) << cell;
    EXPECT_EQ(parse_csv(csv_line({"a", cell}), "r.csv").rows[0].cells[1], cell);
  }
}

}  // namespace
}  // namespace grader::text
