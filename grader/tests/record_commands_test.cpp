// STAFF ONLY. Tests the commands that read and change the record of a class, from outside.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/record/record.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

// All texts about a student have a word that occurs nowhere else.
SubmissionResult result_of(const string& name, double points) {
  SubmissionResult result;
  result.name = name;
  result.origin = "hand-in /" + name + ".zip";
  ExerciseResult exercise;
  exercise.id = "H2";
  exercise.title = "Two";
  exercise.points = points;
  exercise.max_points = 8;
  exercise.cases = {{"Easy", Status::passed, points, 8, "Feedback for " + name + ".", ""}};
  exercise.staff_log = "log of " + name;
  exercise.pictures = {{"1 s", 0, 0, "picture of " + name, "the reference's", ""}};
  result.exercises = {exercise};
  return result;
}

class RecordCommands : public testing::Test {
 protected:
  RecordCommands() {
    for (const char* name : {"alice", "bobwillgo", "carol", "dave"}) Record(out_).put({result_of(name, 2)});
    EXPECT_EQ(run({"comment", "alice", "all", "x"}).code, 0);  // makes the files
    EXPECT_EQ(run({"unset", "alice", "--kind", "comment"}).code, 0);
  }
  ProgramRun run(std::vector<string> words) const {
    words.insert(words.end(), {"--out", out_.string()});
    return run_hairgrade(words);
  }
  void name_people() const {
    Record(out_).put_people({{"alice", {"Alice Ames", "1", "a@x.de"}, "moodle"},
                             {"bobwillgo", {"Sam Same", "2", "b@x.de"}, "moodle"},
                             {"carol", {"Carol Coe", "3", "c@x.de"}, "moodle"},
                             {"dave", {"Sam Same", "4", "d@x.de"}, "moodle"}});
  }
  std::map<string, string> files() const { return files_in(out_); }
  void expect_refused(const std::vector<string>& words, const string& because) const {
    const ProgramRun refused = run(words);
    EXPECT_EQ(refused.code, 2) << refused.errors;
    EXPECT_TRUE(says(refused.errors, because));
    EXPECT_EQ(refused.errors.find('\n') + 1, refused.errors.size()) << refused.errors;
  }

  hair::TemporaryFolder temporary_{"commands"};
  const fs::path out_ = temporary_.path();
};

TEST_F(RecordCommands, ADecisionIsOnAllPagesAndCanBeTakenBack) {
  const std::map<string, string> before = files();
  ASSERT_EQ(run({"set", "alice", "H2.1", "7.5", "--why", "the test <was> wrong"}).code, 0);
  EXPECT_TRUE(says(files().at("alice/report.html"), "the test &lt;was&gt; wrong"));
  EXPECT_EQ(nlohmann::json::parse(files().at("alice/results.json")).at("score"), 7.5);
  EXPECT_TRUE(says(files().at("grades.csv"), "alice,7.5,8"));
  Record(out_).put({result_of("alice", 3)});
  ASSERT_EQ(run({"comment", "carol", "H2", "well done"}).code, 0);
  EXPECT_NE(files().at("grades.csv").find("alice,7.5,8"), string::npos) << "graded again";
  EXPECT_NE(files().at("index.html").find("conflict: points H2.1</a>"), string::npos);
  const ProgramRun log = run({"log", "alice"});
  EXPECT_NE(log.output.find("points H2.1: 7.5 (computed: 2): the test <was> wrong"), string::npos)
      << log.output;
  EXPECT_NE(log.output.find("3 points computed"), string::npos) << log.output;
  EXPECT_NE(run({"diff"}).output.find("alice  H2.1  2 -> 3  Easy"), string::npos) << run({"diff"}).output;
  EXPECT_NE(files().at("changes.html").find("H2.1 2 -&gt; 3"), string::npos);
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
  const string course = (temporary_.path() / "course.json").string();
  std::ofstream(course) << R"({"exercises": {}, "hand_in": {"due": "2025-03-04 23:59"}})";
  EXPECT_NE(run({"whatif", course}).errors.find("nobody knows whether these are late"), string::npos);
}

TEST_F(RecordCommands, KeepWhomTheyHoldOutOfFeedbackAndGradebookAndRememberWhatWasPublished) {
  name_people();
  const string sheet = (temporary_.path() / "sheet.csv").string(),
               table = (temporary_.path() / "t.csv").string(),
               archive = (temporary_.path() / "f.zip").string();
  std::ofstream(sheet)
      << "Identifier,Full name,Status,Grade,Maximum grade,Grade can be changed,Last modified "
         "(submission),Last modified (grade),Feedback comments\n"
         "Participant 1,Alice Ames,Submitted for grading,,8.00,Yes,-,-,\n"
         "Participant 3,Carol Coe,Submitted for grading,,8.00,Yes,-,-,\n";
  const auto give_back = [&](bool held) {
    const ProgramRun feedback =
        run_hairgrade({"feedback", "moodle", sheet, "--grades", out_.string(), "--out", archive});
    const ProgramRun gradebook = run_hairgrade(
        {"gradebook", "moodle", "--fill", sheet, "--grades", out_.string(), "--out", table, "--overwrite"});
    EXPECT_NE(feedback.output.find(held ? "1 reports" : "2 reports"), string::npos) << feedback.errors;
    EXPECT_EQ(hair::bytes_of(table).find("Alice Ames,Submitted for grading,2,") == string::npos, held);
    EXPECT_NE(hair::bytes_of(table).find("Carol Coe,Submitted for grading,2,"), string::npos);
    for (const ProgramRun& run : {feedback, gradebook})
      EXPECT_EQ(run.errors.find("alice: gets nothing, since ") != string::npos, held) << run.errors;
  };
  const auto published = [&] {
    EXPECT_EQ(run({"diff", "--published", table}).code, 0);
    return hair::bytes_of(table);
  };
  ASSERT_EQ(run({"hold", "Alice Ames", "--why", "a secret case"}).code, 0);
  EXPECT_EQ(files().at("alice/report.html").find("a secret case"), string::npos);
  give_back(true);
  ASSERT_EQ(run({"set", "alice", "H2", "5", "--why", "x"}).code, 0);
  ASSERT_EQ(run({"set", "carol", "H2.1", "5", "--why", "x"}).code, 0);
  EXPECT_NE(
      published().find("\r\ncarol,Carol Coe,3,c@x.de,2,5,H2.1 Easy 2 -> 5,Your total was 2 of 8 points and "
                       "is 5 of 8 now: H2.1 Easy 2 -> 5.,20"),
      string::npos)
      << published();
  EXPECT_NE(published().find(",gradebook moodle\r\n"), string::npos);
  EXPECT_EQ(published().find("alice"), string::npos) << "nothing of alice was published";
  ASSERT_EQ(run({"unset", "alice", "H2"}).code + run({"unset", "carol", "H2.1"}).code, 0);
  EXPECT_EQ(published().find("carol"), string::npos);
  ASSERT_EQ(run({"unhold", "alice"}).code, 0);
  give_back(false);
  EXPECT_NE(run({"log", "alice"}).output.find("published  2 of 8 points, by gradebook moodle\n"),
            string::npos);
}

TEST_F(RecordCommands, ACommentChangesForAllWhoHaveIt) {
  ASSERT_EQ(run({"comment", "alice", "H2.1", "too <long>", "--points", "-0.5"}).code, 0);
  ASSERT_EQ(run({"comment", "carol", "H2", "--id", "2"}).code, 0);
  const ProgramRun changed = run({"comments", "2", "--points", "-1.5"});
  EXPECT_EQ(changed.output, "2  -1.5 points  too <long>\n    alice H2.1, carol H2\n") << changed.errors;
  EXPECT_EQ(run({"comments"}).output, "1  x\n    nobody\n" + changed.output);
  for (const char* name : {"alice", "carol"}) {
    EXPECT_NE(files().at(string(name) + "/report.html").find("too &lt;long&gt; (-1.5 points)"), string::npos);
    EXPECT_EQ(nlohmann::json::parse(files().at(string(name) + "/results.json")).at("score"), 0.5);
  }
  expect_refused({"comment", "alice", "H2"}, "--id");
  expect_refused({"comment", "alice", "H2", "x", "--id", "2"}, "--id");
  expect_refused({"comment", "alice", "H2", "--id", "9"}, "there is no comment 9");
  expect_refused({"comment", "alice", "H9", "x"}, "is no place");
}

TEST_F(RecordCommands, ARequestIsAnsweredOnce) {
  EXPECT_EQ(run({"request", "alice", "H2.1", "why <2>?"}).output, "request 1\n");
  EXPECT_NE(files().at("alice/report.html").find("not answered yet"), string::npos);
  EXPECT_NE(run({"requests"}).output.find("alice H2.1  why <2>?\n1 open\n"), string::npos);
  ASSERT_EQ(run({"answer", "1", "since"}).code, 0);
  EXPECT_NE(files().at("alice/report.html").find("The staff answered on "), string::npos);
  EXPECT_NE(run({"requests"}).output.find("  since\n0 open\n"), string::npos) << run({"requests"}).output;
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
  const auto enter = [&](const string& table) {
    hair::write_file(temporary_.path() / "t.csv", table);
    return run({"enter", (temporary_.path() / "t.csv").string()});
  };
  const string table =
      "id,name,Oral examination,style,late days,why,request,place\n"
      "alice1,A,7,\"1,5\",2,ill,=why?,H2.1\nalice1,A,,,,,and this,all\n"
      "bobwillgo1,B,11,-,x,,,\ncarol1,C,,2,,,,H9\nd1,D,3,1,,,,\ne1,E,4,1,,,,\nz1,Z,1,,,,,\n";
  const ProgramRun first = enter(table);
  EXPECT_EQ(first.code, 3);
  EXPECT_EQ(first.output, "7 entered\n") << first.errors;
  for (const char* line : {"line 4: B: \"x\" is no number", "line 4: 11 points: oral is worth 10",
                           "line 8: Z has no hand-in here", "dave: other rows have another number"})
    EXPECT_NE(first.errors.find(line), string::npos) << line << "\n" << first.errors;
  EXPECT_NE(files().at("grades.csv").find("alice,10.5,20"), string::npos) << files().at("grades.csv");
  EXPECT_NE(files().at("alice/report.html").find("=why?"), string::npos);
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
  const ProgramRun elsewhere = run_hairgrade({"export", "--out", (out_ / "staff").string()});
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_FALSE(Record::is_in(out_ / "staff"));
}

}  // namespace
}  // namespace grader
