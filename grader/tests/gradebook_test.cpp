// STAFF ONLY. Tests the way from a roster to a gradebook, with hairgrade.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "grader/tests/in_a_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

class GradesGoBack : public InAFolder {
 protected:
  GradesGoBack() : InAFolder({{"exercises", nlohmann::json::object()}}) {}
  ProgramRun grade(const std::vector<string>& samples, const std::vector<string>& options) const {
    std::vector<string> words = {"--exercise", "S2"};
    for (const string& name : samples) words.push_back(sample(name));
    words.insert(words.end(), options.begin(), options.end());
    return InAFolder::grade(words);
  }
};

TEST_F(GradesGoBack, EverybodyOnTheRosterHasARowAndGradesAreFilledIn) {
  const string roster = write("roster.csv", "login;id;name\r\nperfect;0011;Jörg Müller\r\ngone;12;Zoë\r\n");
  const ProgramRun graded = grade({"perfect", "stubs"}, {"--roster", roster});
  EXPECT_EQ(graded.code, 3) << graded.errors;
  EXPECT_TRUE(says(graded.errors, "handed in nothing: Zoë (12); a roster whose column \"id\" has"));
  EXPECT_TRUE(says(graded.output, "roster: 1 of 2 handed in\n"));
  EXPECT_TRUE(says(graded.errors, "roster.csv: its separator is a semicolon\n"));
  EXPECT_TRUE(
      says(graded.errors, "stubs: is on no roster (its name is on no roster), and graded all the same\n"));
  const string csv = read("grades/grades.csv");
  EXPECT_TRUE(says(csv, ",Zoë,12,,,nothing handed in\r\n"));
  EXPECT_TRUE(says(csv, ",Jörg Müller,0011,,,\r\n"));
  EXPECT_TRUE(says(csv, "\r\nstubs,0,"));
  EXPECT_TRUE(says(read("grades/index.html"), "Zoë"));

  // Another run of hairgrade keeps the roster.
  EXPECT_EQ(grade({"textbook"}, {}).code, 3);
  EXPECT_TRUE(says(read("grades/grades.csv"), ",Zoë,12,,,nothing handed in\r\n"));

  const string exported =
      write("exported.csv",
            "Student,ID,SIS Login ID,Section,S2 (7)\n    Points Possible,,,,20\n\"Müller, "
            "Jörg\",4711,perfect,A,\n\"Z, Zoë\",4712,gone,A,3\n");
  const ProgramRun filled = run_hairgrade(
      {"gradebook", "canvas", "--grades", path("grades"), "--fill", exported, "--out", path("filled.csv")});
  EXPECT_EQ(filled.code, 3) << "stubs and textbook have no row: " << filled.errors;
  EXPECT_EQ(read("filled.csv"),
            "Student,ID,SIS Login ID,Section,S2 (7)\n    Points Possible,,,,20\n\"Müller, "
            "Jörg\",4711,perfect,A,20\n\"Z, Zoë\",4712,gone,A,3\n");
  EXPECT_EQ(filled.output.find("1 grades in "), 0u) << filled.output;

  // Grades go back with people's decisions.
  const auto cell_after = [&](const std::vector<string>& decision, const string& cell = "",
                              const char* option = "--scale") {
    EXPECT_EQ(run_hairgrade(decision).code, 0) << decision.front();
    string table = read("exported.csv");
    table.replace(table.find("perfect,A,"), 10, "perfect,A," + cell);
    run_hairgrade({"gradebook", "canvas", "--grades", path("grades"), "--fill", write("again.csv", table),
                   "--out", path("decided.csv"), option});
    const string decided = read("decided.csv"), before = "4711,perfect,A,";
    const std::size_t at = decided.find(before) + before.size();
    return decided.substr(at, decided.find('\n', at) - at);
  };
  EXPECT_EQ(cell_after({"set", "perfect", "S2", "12.5", "--why", "a talk", "--out", path("grades")}), "12.5");
  // An earlier call entered 20 and 12.5, and a person 19.
  const std::vector<string> decision{"set",   "perfect", "S2",    "13",
                                     "--why", "a talk",  "--out", path("grades")};
  EXPECT_EQ(cell_after(decision, "20.00"), "13");
  EXPECT_EQ(cell_after(decision, "12.5"), "13");
  EXPECT_EQ(cell_after(decision, "19"), "19");
  EXPECT_EQ(cell_after(decision, "19", "--overwrite"), "13");
  EXPECT_EQ(cell_after({"excuse", "perfect", "--why", "ill", "--out", path("grades")}), "EX");
}

TEST_F(GradesGoBack, BadInputIsALine) {
  ASSERT_EQ(grade({"stubs"}, {}).code, 0);
  const auto refused = [&](const std::vector<string>& words, const string& line) {
    expect_refused(run_hairgrade(words), line);
  };
  const string bad = write("bad.csv", "id,name\n1,\"A\n"), out = path("out.csv"), grades = path("grades");
  refused({"grade", sample("stubs"), "--out", grades, "--roster", bad},
          "bad.csv, line 2: a quote begins here and never ends");
  refused({"gradebook", "canvas", "--grades", grades, "--out", out}, "needs --fill");
  refused({"gradebook", "canvas", "--grades", path("elsewhere"), "--fill", bad, "--out", out},
          "has no class.sqlite");
  refused({"gradebook", "canvas", "--grades", grades, "--fill", bad, "--out", bad},
          "is the exported table itself");
  refused({"gradebook", "sakai", "--grades", grades, "--out", out}, "sakai");
  refused({"feedback", "moodle", bad, "--grades", grades, "--out", path("x.tar")}, "the archive is a .zip");
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace grader
