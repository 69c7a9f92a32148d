// STAFF ONLY. Tests groups and participants of a learning system, from the download to the gradebook, and
// again with the next download.
#include "grader/record/record.h"
#include "grader/tests/in_a_folder.h"
#include "grader/text/letters.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;
using Words = std::vector<string>;

class SecondDownload : public InAFolder {
 protected:
  SecondDownload() : InAFolder(course_of({"S1"})) {}
  // Replaces the download. Its files don't compile, which saves time.
  void download(const Words& names) const {
    fs::remove_all(root_ / "class");
    for (const string& name : names) write("class/" + name, "no\n");
  }
  ProgramRun grade(Words more) const {
    more.insert(more.begin(), path("class"));
    return InAFolder::grade(more);
  }
  Words names() const { return Record(root_ / "grades").names(); }
};

constexpr const char* kTitles =
    "name,canvas_user_id,user_id,login_id,sections,group_name,canvas_group_id,group_id\n";
const string kRoster = string(kTitles) +
                       "\"Muster, Erika\",4713,900,jd,Lab A,Team 7,55,\n\"Lee, Sam\",4714,901,sl,Lab B,Team "
                       "7,55,\n\"Poe, Ann\",4715,902,ap,Lab A,,,\n\"Roe, Max\",4716,903,mr,Lab A,,,\n";
const string kLater = string(kTitles) +
                      "\"Muster, Erika\",4713,900,jd,Lab A,Rockets,55,\n\"Lee, Sam\",4714,901,sl,Lab "
                      "B,Rockets,55,\n\"Poe, Ann\",4715,902,ap,Lab A,Rockets,55,\n\"Roe, "
                      "Max\",4716,903,mr,Lab A,,,\n";

TEST_F(SecondDownload, AGroupOfCanvasKeepsItsRowUnderAnotherName) {
  download({"team7_4713_90001_conj_grad.cpp", "roemax_LATE_4716_90002_conj_grad.cpp"});
  const ProgramRun first = grade({"--roster", write("roster.csv", kRoster)});
  ASSERT_EQ(first.code, 0) << first.errors;
  EXPECT_TRUE(says(first.output, "roster: 3 of 4 handed in")) << first.output;
  EXPECT_TRUE(says(first.errors, "1 hand-ins have names of the roster's groups and count for 2 people"))
      << first.errors;
  EXPECT_EQ(names(), (Words{"roemax_4716", "team7_4713"}));
  EXPECT_TRUE(says(read("grades/index.html"), "Team 7 (Muster, Erika; Lee, Sam)"));
  EXPECT_TRUE(
      says(read("grades/index.html"), "Roe, Max</a></th><td></td><td colspan=\"3\">marked late by Canvas"));
  const string exported = run({"export"}).output;
  EXPECT_TRUE(says(exported.substr(exported.find("roemax_4716")), "\"marked_late\": true"));
  ASSERT_EQ(run({"set", "team7_4713", "S1", "5", "--why", "a talk"}).code, 0);
  ASSERT_EQ(run({"comment", "team7_4713", "all", "Well spoken."}).code, 0);

  // Another member hands in for the group, which has another name and a new member; the mark has gone.
  download({"rockets_4714_90011_conj_grad.cpp", "roemax_4716_90002_conj_grad.cpp"});
  const ProgramRun second = grade({"--resume", "--roster", write("roster.csv", kLater)});
  EXPECT_TRUE(says(second.errors, "rockets_4714: is team7_4713 under another name, and keeps its row"))
      << second.errors;
  EXPECT_TRUE(says(second.output, "0 graded, 2 kept")) << second.output << second.errors;
  EXPECT_EQ(names(), (Words{"roemax_4716", "team7_4713"}));
  EXPECT_TRUE(says(read("grades/team7_4713/report.html"), "Well spoken."));
  EXPECT_TRUE(says(read("grades/index.html"), "Rockets (Muster, Erika; Lee, Sam; Poe, Ann)"));
  EXPECT_FALSE(says(read("grades/index.html"), "marked late"));

  write("export.csv",
        "Student,ID,SIS Login ID,Section,Lab (7)\n    Points Possible,,,,32\n\"Muster, "
        "Erika\",4713,jd,A,\n\"Lee, "
        "Sam\",4714,sl,A,\n\"Poe, Ann\",4715,ap,A,\n\"Roe, Max\",4716,mr,A,\n");
  const ProgramRun filled = run_hairgrade({"gradebook", "canvas", "--grades", path("grades"), "--fill",
                                           path("export.csv"), "--out", path("filled.csv")});
  ASSERT_EQ(filled.code, 0) << filled.errors;
  for (const char* row : {"4713,jd,A,5\n", "4714,sl,A,5\n", "4715,ap,A,5\n", "4716,mr,A,0\n"})
    EXPECT_TRUE(says(read("filled.csv"), row)) << read("filled.csv");

  // A later run has no roster of its own; a member has left, so it is another group's work.
  write("roster.csv", string(kTitles) + "\"Muster, Erika\",4713,900,jd,Lab A,Solo,55,\n");
  download({"solo_4713_90021_conj_grad.cpp", "roemax_4716_90002_conj_grad.cpp"});
  const ProgramRun third = grade({"--resume", "--roster", path("roster.csv")});
  EXPECT_TRUE(says(third.errors, "solo_4713: is team7_4713, but somebody has left it")) << third.errors;
  EXPECT_EQ(names(), (Words{"roemax_4716", "solo_4713", "team7_4713"}));
  EXPECT_FALSE(says(read("grades/solo_4713/report.html"), "Well spoken."));
}

TEST_F(SecondDownload, EverybodyOnTheRosterHasARowAndLaterRunsKeepTheRoster) {
  download({"ada/conj_grad.cpp", "eve/conj_grad.cpp"});
  const ProgramRun graded =
      grade({"--roster", write("roster.csv", "login;id;name\r\nada;0011;Jörg Müller\r\ngone;12;Zoë\r\n")});
  EXPECT_EQ(graded.code, 3) << graded.errors;
  EXPECT_TRUE(says(graded.output, "roster: 1 of 2 handed in\n"));
  for (const char* line : {"handed in nothing: Zoë (12); a roster whose column \"id\" has",
                           "roster.csv: its separator is a semicolon\n",
                           "eve: is on no roster (its name is on no roster), and graded all the same\n"})
    EXPECT_TRUE(says(graded.errors, line));
  EXPECT_TRUE(says(read("grades/index.html"), "Zoë"));
  EXPECT_EQ(grade({"--only", "eve"}).code, 3);
  for (const char* row : {",Zoë,12,,,nothing handed in\r\n", ",Jörg Müller,0011,,,\r\n", "\r\neve,0,"})
    EXPECT_TRUE(says(read("grades/grades.csv"), row));

  const string head = "Student,ID,SIS Login ID,Section,S1 (7)\n    Points Possible,,,,32\n";
  const ProgramRun filled =
      run_hairgrade({"gradebook", "canvas", "--grades", path("grades"), "--out", path("filled.csv"), "--fill",
                     write("export.csv", head + "\"Müller, Jörg\",4711,ada,A,\n\"Z, Zoë\",4712,gone,A,3\n")});
  EXPECT_EQ(filled.code, 3) << "eve has no row: " << filled.errors;
  EXPECT_EQ(read("filled.csv"), head + "\"Müller, Jörg\",4711,ada,A,0\n\"Z, Zoë\",4712,gone,A,3\n");
  EXPECT_TRUE(filled.output.starts_with("1 grades in ")) << filled.output;
}

// In Moodle's own blind download staff know nobody, and the worksheet with names comes later.
TEST_F(SecondDownload, MoodlesParticipantsInABlindClassFindTheirPeople) {
  download({"Teilnehmer_4713_assignsubmission_file/conj_grad.cpp",
            "Teilnehmer_4714_assignsubmission_file/conj_grad.cpp"});
  const ProgramRun first = grade({"--anonymous"});
  ASSERT_EQ(first.code, 0) << first.errors;
  EXPECT_TRUE(says(first.output, "Moodle")) << first.output;
  const Words codes = names();
  ASSERT_EQ(codes.size(), 2U);
  for (const string& code : codes) EXPECT_TRUE(code.starts_with("code-")) << code;

  const string sheet = write(
      "sheet.csv",
      "Identifier,Full name,Status,Grade,Maximum grade,Grade can be changed,Last modified (submission),Last "
      "modified (grade),Feedback comments\nParticipant 4713,Erika Muster,x,,32.00,Yes,\"Tuesday, 4 March "
      "2025, "
      "10:15 "
      "AM\",-,\nParticipant 4714,Sam Lee,x,,32.00,Yes,-,-,\nParticipant 4715,Ann Poe,x,,32.00,Yes,-,-,\n");
  const ProgramRun second = grade({"--resume", "--roster", sheet, "--times", sheet});
  EXPECT_EQ(second.code, 0) << second.errors;
  EXPECT_TRUE(says(second.output, "roster: 2 of 3 handed in")) << second.output;
  EXPECT_TRUE(says(second.output, "0 graded, 2 kept")) << second.output;
  EXPECT_EQ(names(), codes);
  string all = second.output + second.errors;
  for (const auto& entry : fs::recursive_directory_iterator(root_ / "grades"))
    if (!entry.path().filename().string().starts_with(kRecordFile))
      all += entry.path().string() + "\n" + (entry.is_regular_file() ? hair::bytes_of(entry.path()) : "");
  for (const char* name : {"4713", "4714", "erika", "muster", "sam lee", "ann poe"})
    EXPECT_FALSE(says(lowered(all), name)) << name;
  const string code = Record(root_ / "grades").codes().at("Teilnehmer_4713");
  EXPECT_EQ(Record(root_ / "grades").handed_in(code), "Tuesday, 4 March 2025, 10:15 AM");

  // The version is the same, and nobody gives the table again.
  EXPECT_TRUE(says(grade({"--only", code}).output, "1 graded"));
  EXPECT_EQ(Record(root_ / "grades").handed_in(code), "Tuesday, 4 March 2025, 10:15 AM");

  ASSERT_EQ(run({"set", code, "S1", "5", "--why", "x"}).code, 0);
  const ProgramRun filled = run_hairgrade(
      {"gradebook", "moodle", "--grades", path("grades"), "--fill", sheet, "--out", path("filled.csv")});
  ASSERT_EQ(filled.code, 0) << filled.errors;
  EXPECT_TRUE(says(read("filled.csv"), "Participant 4713,Erika Muster,x,5,32.00")) << read("filled.csv");
  EXPECT_TRUE(says(read("filled.csv"), "Participant 4715,Ann Poe,x,,32.00")) << read("filled.csv");
}

}  // namespace
}  // namespace grader
