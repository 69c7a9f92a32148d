// STAFF ONLY. Tests the commands that read and change the record of a class, from outside.
#include "grader/record/record.h"
#include "grader/tests/in_a_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

// All texts about a student have a word that occurs nowhere else.
SubmissionResult result_of(const string& name, double points) {
  const ExerciseResult exercise{
      .id = "H2",
      .title = "Two",
      .points = points,
      .max_points = 8,
      .cases = {{"Easy", Status::passed, points, 8, "Feedback for " + name + ".", ""}},
      .pictures = {{"1 s", 0, 0, "picture of " + name, "the reference's", ""}},
      .staff_log = "log of " + name};
  return {.name = name, .origin = "hand-in /" + name + ".zip", .exercises = {exercise}};
}

class RecordCommands : public InAFolder {
 protected:
  RecordCommands() : InAFolder({{"exercises", nlohmann::json::object()}}) {
    fs::create_directory(out_);
    for (const char* name : {"alice", "bobwillgo", "carol", "dave"}) Record(out_).put({result_of(name, 2)});
    EXPECT_EQ(run({"comment", "alice", "all", "x"}).code, 0);  // makes the files
    EXPECT_EQ(run({"unset", "alice", "--kind", "comment"}).code, 0);
  }
  void name_people() const {
    Record(out_).put_people({{"alice", {"Alice Ames", "1", "a@x.de"}, "moodle"},
                             {"bobwillgo", {"Sam Same", "2", "b@x.de"}, "moodle"},
                             {"carol", {"Carol Coe", "3", "c@x.de"}, "moodle"},
                             {"dave", {"Sam Same", "4", "d@x.de"}, "moodle"}});
  }
  std::map<string, string> files() const { return files_in(out_); }
  void expect_refused(const std::vector<string>& words, const string& because) const {
    InAFolder::expect_refused(run(words), because);
  }

  const fs::path out_ = root_ / "grades";
};

TEST_F(RecordCommands, ADecisionIsOnAllPagesAndCanBeTakenBack) {
  const std::map<string, string> before = files();
  ASSERT_EQ(run({"set", "alice", "H2.1", "7.5", "--why", "the test <was> wrong"}).code, 0);
  EXPECT_TRUE(says(files().at("alice/report.html"), "the test &lt;was&gt; wrong"));
  EXPECT_EQ(nlohmann::json::parse(files().at("alice/results.json")).at("score"), 7.5);
  EXPECT_TRUE(says(files().at("grades.csv"), "alice,7.5,8"));
  Record(out_).put({result_of("alice", 3)});
  ASSERT_EQ(run({"comment", "carol", "H2", "well done"}).code, 0);
  EXPECT_TRUE(says(files().at("grades.csv"), "alice,7.5,8")) << "graded again";
  EXPECT_TRUE(says(files().at("index.html"), "conflict: points H2.1</a>"));
  const ProgramRun log = run({"log", "alice"});
  EXPECT_TRUE(says(log.output, "points H2.1: 7.5 (computed: 2): the test <was> wrong"));
  EXPECT_TRUE(says(log.output, "3 points computed"));
  EXPECT_TRUE(says(run({"diff"}).output, "alice  H2.1  2 -> 3  Easy"));
  EXPECT_TRUE(says(files().at("changes.html"), "H2.1 2 -&gt; 3"));
  for (int i = 0; i < 2; ++i) Record(out_).put({result_of("alice", 2)});
  ASSERT_EQ(run({"unset", "alice", "H2.1"}).code, 0);
  ASSERT_EQ(run({"unset", "carol", "H2", "--kind", "comment"}).code, 0);
  EXPECT_EQ(files(), before);
}

TEST_F(RecordCommands, FindPeopleAsTheRosterCallsThemAndPrintOldAndNewPoints) {
  name_people();
  const string old = "Alice Ames (alice): H2.1 2, 2 of 8 points -> H2.1 7, 7 of 8 points\n";
  for (const char* name : {"alice", "Alice Ames", "Ames, Alice", "alice ames", "1", "A@x.de"}) {
    const ProgramRun set = run({"set", name, "H2.1", "7", "--why", "x"});
    EXPECT_EQ(set.output, old) << name << set.errors;
    EXPECT_EQ(run({"unset", name, "H2.1"}).code, 0);
  }
  EXPECT_EQ(run({"excuse", "Alice Ames", "H2", "--why", "x"}).output,
            "Alice Ames (alice): H2 2, 2 of 8 points -> H2 0, 0 of 0 points\n");
  EXPECT_EQ(run({"unset", "alice", "--kind", "excuse"}).output,
            "Alice Ames (alice): 0 of 0 points -> 2 of 8 points\n");
  expect_refused({"comment", "Sam Same", "all", "x"}, "Sam Same: may be bobwillgo, dave; write one of these");
  const string course = write("due.json", R"({"exercises": {}, "hand_in": {"due": "2025-03-04 23:59"}})");
  EXPECT_TRUE(says(run({"whatif", course}).errors, "nobody knows whether these are late"));
}

TEST_F(RecordCommands, KeepWhomTheyHoldOutOfFeedbackAndGradebookAndRememberWhatWasPublished) {
  name_people();
  const string sheet =
                   write("sheet.csv",
                         "Identifier,Full name,Status,Grade,Maximum grade,Grade can be changed,Last modified "
                         "(submission),Last modified (grade),Feedback comments\n"
                         "Participant 1,Alice Ames,Submitted for grading,,8.00,Yes,-,-,\n"
                         "Participant 3,Carol Coe,Submitted for grading,,8.00,Yes,-,-,\n"),
               table = path("t.csv"), archive = path("f.zip");
  const auto give_back = [&](bool held) {
    const ProgramRun feedback =
        run_hairgrade({"feedback", "moodle", sheet, "--grades", out_.string(), "--out", archive});
    const ProgramRun gradebook = run_hairgrade(
        {"gradebook", "moodle", "--fill", sheet, "--grades", out_.string(), "--out", table, "--overwrite"});
    EXPECT_TRUE(says(feedback.output, held ? "1 reports" : "2 reports")) << feedback.errors;
    EXPECT_EQ(hair::bytes_of(table).find("Alice Ames,Submitted for grading,2,") == string::npos, held);
    EXPECT_TRUE(says(hair::bytes_of(table), "Carol Coe,Submitted for grading,2,"));
    for (const ProgramRun& run : {feedback, gradebook})
      EXPECT_EQ(run.errors.find("alice: gets nothing, since ") != string::npos, held) << run.errors;
  };
  const auto published = [&] {
    EXPECT_EQ(run({"diff", "--published", table}).code, 0);
    return hair::bytes_of(table);
  };
  ASSERT_EQ(run({"hold", "Alice Ames", "--why", "a secret case"}).code, 0);
  EXPECT_FALSE(says(files().at("alice/report.html"), "a secret case"));
  give_back(true);
  ASSERT_EQ(run({"set", "alice", "H2", "5", "--why", "x"}).code, 0);
  ASSERT_EQ(run({"set", "carol", "H2.1", "5", "--why", "x"}).code, 0);
  EXPECT_TRUE(says(published(),
                   "\r\ncarol,Carol Coe,3,c@x.de,2,5,H2.1 Easy 2 -> 5,Your total was 2 of 8 points and "
                   "is 5 of 8 now: H2.1 Easy 2 -> 5.,20"));
  EXPECT_TRUE(says(published(), ",gradebook moodle\r\n"));
  EXPECT_FALSE(says(published(), "alice")) << "nothing of alice was published";
  ASSERT_EQ(run({"unset", "alice", "H2"}).code + run({"unset", "carol", "H2.1"}).code, 0);
  EXPECT_FALSE(says(published(), "carol"));
  ASSERT_EQ(run({"unhold", "alice"}).code, 0);
  give_back(false);
  EXPECT_TRUE(says(run({"log", "alice"}).output, "published  2 of 8 points, by gradebook moodle\n"));
}

// The first call enters 2 points; others come from a person.
TEST_F(RecordCommands, AGradebookHasDecisionsAndKeepsWhatAPersonEntered) {
  Record(out_).put_people({{"alice", {"Alice Ames", "1", "a@x.de"}, "canvas"}});
  const auto cell = [&](const string& there, const char* option = "--scale") {
    run_hairgrade({"gradebook", "canvas", "--grades", out_.string(), "--out", path("filled.csv"), "--fill",
                   write("t.csv",
                         "Student,ID,SIS Login ID,Section,H2 (7)\n    Points Possible,,,,8\n\"Ames, "
                         "Alice\",1,aa,A," +
                             there + "\n"),
                   option});
    const string filled = read("filled.csv"), before = "1,aa,A,";
    const std::size_t at = filled.find(before) + before.size();
    return filled.substr(at, filled.find('\n', at) - at);
  };
  EXPECT_EQ(cell(""), "2");
  ASSERT_EQ(run({"set", "alice", "H2", "5.5", "--why", "a talk"}).code, 0);
  for (const char* ours : {"2.00", "2", "5.5"}) EXPECT_EQ(cell(ours), "5.5");
  EXPECT_EQ(cell("7"), "7");
  EXPECT_EQ(cell("7", "--overwrite"), "5.5");
  ASSERT_EQ(run({"excuse", "alice", "--why", "ill"}).code, 0);
  EXPECT_EQ(cell("5.5"), "EX");
}

TEST_F(RecordCommands, ACommentChangesForAllWhoHaveIt) {
  ASSERT_EQ(run({"comment", "alice", "H2.1", "too <long>", "--points", "-0.5"}).code, 0);
  ASSERT_EQ(run({"comment", "carol", "H2", "--id", "2"}).code, 0);
  const ProgramRun changed = run({"comments", "2", "--points", "-1.5"});
  EXPECT_EQ(changed.output, "2  -1.5 points  too <long>\n    alice H2.1, carol H2\n") << changed.errors;
  EXPECT_EQ(run({"comments"}).output, "1  x\n    nobody\n" + changed.output);
  for (const char* name : {"alice", "carol"}) {
    EXPECT_TRUE(says(files().at(string(name) + "/report.html"), "too &lt;long&gt; (-1.5 points)"));
    EXPECT_EQ(nlohmann::json::parse(files().at(string(name) + "/results.json")).at("score"), 0.5);
  }
  expect_refused({"comment", "alice", "H2"}, "--id");
  expect_refused({"comment", "alice", "H2", "x", "--id", "2"}, "--id");
  expect_refused({"comment", "alice", "H2", "--id", "9"}, "there is no comment 9");
  expect_refused({"comment", "alice", "H9", "x"}, "is no place");
}

TEST_F(RecordCommands, ARequestIsAnsweredOnce) {
  EXPECT_EQ(run({"request", "alice", "H2.1", "why <2>?"}).output, "request 1\n");
  EXPECT_TRUE(says(files().at("alice/report.html"), "not answered yet"));
  EXPECT_TRUE(says(run({"requests"}).output, "alice H2.1  why <2>?\n1 open\n"));
  ASSERT_EQ(run({"answer", "1", "since"}).code, 0);
  EXPECT_TRUE(says(files().at("alice/report.html"), "The staff answered on "));
  EXPECT_TRUE(says(run({"requests"}).output, "  since\n0 open\n"));
  expect_refused({"answer", "1", "again"}, "answered once");
}

TEST_F(RecordCommands, ATableHasPointsDaysAndRequests) {
  HandInRules rules;
  rules.by_hand = {{"oral", {10, "Oral examination"}}, {"style", {2}}};
  std::vector<HandIn> hand_ins;
  for (const char* name : {"alice", "bobwillgo", "carol"})
    hand_ins.push_back({name, {.name = name, .id = string(name) + "1"}, "folders"});
  const auto team = [](const char* one, const char* other) {
    return Owner{.name = "team", .group = true, .members = {{.id = one}, {.id = other}}};
  };
  hand_ins.push_back({"dave", team("d1", "e1"), "folders"});
  Record(out_).put_people(hand_ins);
  Record(out_).set_rules(rules);
  const auto enter = [&](const string& table) { return run({"enter", write("t.csv", table)}); };
  const string table =
      "id,name,Oral examination,style,late days,why,request,place\n"
      "alice1,A,7,\"1,5\",2,ill,=why?,H2.1\nalice1,A,,,,,and this,all\n"
      "bobwillgo1,B,11,-,x,,,\ncarol1,C,,2,,,,H9\nd1,D,3,1,,,,\ne1,E,4,1,,,,\nz1,Z,1,,,,,\n";
  const ProgramRun first = enter(table);
  EXPECT_EQ(first.code, 3);
  EXPECT_EQ(first.output, "7 entered\n") << first.errors;
  for (const char* line : {"line 4: B: \"x\" is no number", "line 4: 11 points: oral is worth 10",
                           "line 8: Z has no hand-in here", "dave: other rows have another number"})
    EXPECT_TRUE(says(first.errors, line));
  EXPECT_TRUE(says(files().at("grades.csv"), "alice,10.5,20"));
  EXPECT_TRUE(says(files().at("alice/report.html"), "=why?"));
  EXPECT_EQ(Record(out_).requests().size(), 2U);
  EXPECT_EQ(enter(table).output, "0 entered\n") << "it was entered before";
  EXPECT_EQ(enter("id,oral\nalice1,8\n").output, "1 entered\n") << "a corrected table";
  EXPECT_EQ(enter("id,orall\nalice1,8\n").code, 2);
}

TEST_F(RecordCommands, SayWhatIsWrongInOneLine) {
  const std::map<string, string> before = files();
  expect_refused({"set", "nobody", "H2", "1", "--why", "x"}, "nobody in ");
  expect_refused({"set", "alice", "H2", "1"}, "--why");
  expect_refused({"log", "nobody"}, "nobody in ");
  expect_refused({"forget", "../alice"}, "nobody in ");
  EXPECT_EQ(files(), before);
  fs::create_directory(out_ / ".slurm-1");
  expect_refused({"forget", "alice"}, "its hand-ins are on a cluster, which would bring alice back; ");
  const string bad = write("bad.csv", "id,name\n1,\"A\n"), out = path("out.csv"), grades = out_.string();
  for (const auto& [words, because] : std::vector<std::pair<std::vector<string>, string>>{
           {{"grade", sample("stubs"), "--out", grades, "--roster", bad},
            "bad.csv, line 2: a quote begins here and never ends"},
           {{"gradebook", "canvas", "--grades", grades, "--out", out}, "needs --fill"},
           {{"gradebook", "canvas", "--grades", path("elsewhere"), "--fill", bad, "--out", out},
            "has no class.sqlite"},
           {{"gradebook", "canvas", "--grades", grades, "--fill", bad, "--out", bad},
            "is the exported table itself"},
           {{"gradebook", "sakai", "--grades", grades, "--out", out}, "sakai"},
           {{"feedback", "moodle", bad, "--grades", grades, "--out", path("x.tar")},
            "the archive is a .zip"}})
    InAFolder::expect_refused(run_hairgrade(words), because);
  EXPECT_FALSE(fs::exists(out));
  const ProgramRun elsewhere = run_hairgrade({"export", "--out", (out_ / "staff").string()});
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_FALSE(Record::is_in(out_ / "staff"));
}

}  // namespace
}  // namespace grader
