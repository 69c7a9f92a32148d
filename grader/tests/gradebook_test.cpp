// STAFF ONLY. Tests the way from a roster to a gradebook, with hairgrade.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;

class GradesGoBack : public testing::Test {
 protected:
  string write(const string& name, const string& text) const {
    std::ofstream(folder_.path() / name) << text;
    return path(name);
  }
  string path(const string& name) const { return (folder_.path() / name).string(); }
  string read(const string& name) const { return hair::bytes_of(folder_.path() / name); }

  ProgramRun grade(const std::vector<string>& samples, const std::vector<string>& options) const {
    std::vector<string> words = {
        "grade",   "--out",       path("grades"), "--exercise",
        "S2",      "--no-images", "--secret",     write("secret", "a secret for this test"),
        "--cache", path("cache")};
    for (const string& name : samples) words.push_back(sample(name));
    words.insert(words.end(), options.begin(), options.end());
    return run_hairgrade(words);
  }

  hair::TemporaryFolder folder_{"gradebook"};
};

TEST_F(GradesGoBack, EverybodyOnTheRosterHasARowAndGradesAreFilledIn) {
  const string roster = write("roster.csv", "login;id;name\r\nperfect;0011;Jörg Müller\r\ngone;12;Zoë\r\n");
  const ProgramRun graded = grade({"perfect", "stubs"}, {"--roster", roster});
  EXPECT_EQ(graded.code, 3) << graded.errors;
  EXPECT_NE(graded.errors.find("handed in nothing: Zoë (12); a roster whose column \"id\" has"), string::npos)
      << graded.errors;
  EXPECT_NE(graded.output.find("roster: 1 of 2 handed in\n"), string::npos) << graded.output;
  EXPECT_NE(graded.errors.find("roster.csv: its separator is a semicolon\n"), string::npos) << graded.errors;
  EXPECT_NE(
      graded.errors.find("stubs: is on no roster (its name is on no roster), and graded all the same\n"),
      string::npos)
      << graded.errors;
  const string csv = read("grades/grades.csv");
  EXPECT_NE(csv.find(",Zoë,12,,,nothing handed in\r\n"), string::npos) << csv;
  EXPECT_NE(csv.find(",Jörg Müller,0011,,,\r\n"), string::npos) << csv;
  EXPECT_NE(csv.find("\r\nstubs,0,"), string::npos) << csv;
  EXPECT_NE(read("grades/index.html").find("Zoë"), string::npos);

  // Another run of hairgrade keeps the roster.
  EXPECT_EQ(grade({"textbook"}, {}).code, 3);
  EXPECT_NE(read("grades/grades.csv").find(",Zoë,12,,,nothing handed in\r\n"), string::npos);

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
    const ProgramRun run = run_hairgrade(words);
    EXPECT_EQ(run.code, 2) << run.errors;
    EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
    EXPECT_NE(run.errors.find(line), string::npos) << run.errors;
  };
  const string bad = write("bad.csv", "id,name\n1,\"A\n"), out = path("out.csv"), grades = path("grades");
  refused({"grade", sample("stubs"), "--out", grades, "--roster", bad},
          "bad.csv, line 2: a quote begins here and never ends");
  refused({"grade", sample("stubs"), "--out", grades, "--roster", path("none.csv")},
          "none.csv: can't be read");
  refused({"gradebook", "canvas", "--grades", grades, "--fill", bad, "--out", out}, "never ends");
  refused({"gradebook", "canvas", "--grades", grades, "--out", out}, "needs --fill");
  refused({"gradebook", "canvas", "--grades", path("elsewhere"), "--fill", bad, "--out", out},
          "has no class.sqlite");
  refused({"gradebook", "canvas", "--grades", grades, "--fill", bad, "--out", bad},
          "is the exported table itself");
  refused({"gradebook", "sakai", "--grades", grades, "--out", out}, "sakai");
  refused({"feedback", "canvas", path("none.zip"), "--grades", grades, "--out", path("x.zip")},
          "none.zip: is not there");
  refused({"feedback", "canvas", bad, "--grades", grades, "--out", path("x.zip")}, "bad.csv: can't be read");
  refused({"feedback", "moodle", bad, "--grades", grades, "--out", path("x.tar")}, "the archive is a .zip");
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace grader
