// STAFF ONLY. Tests the commands that read and change the record of a class, from outside.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

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
    EXPECT_EQ(run({"comment", "alice", "x"}).code, 0);  // makes the files
    EXPECT_EQ(run({"unset", "alice", "--kind", "comment"}).code, 0);
  }
  ProgramRun run(std::vector<string> words) const {
    words.insert(words.end(), {"--out", out_.string()});
    return run_hairgrade(words);
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
  ASSERT_EQ(run({"comment", "carol", "well done", "--at", "H2"}).code, 0);
  EXPECT_TRUE(says(files().at("grades.csv"), "alice,7.5,8")) << "graded again";
  const ProgramRun log = run({"log", "alice"});
  EXPECT_TRUE(says(log.output, "points H2.1: 7.5 (computed: 2): the test <was> wrong"));
  EXPECT_TRUE(says(log.output, "3 points computed"));
  EXPECT_TRUE(says(run({"diff"}).output, "alice  H2.1  2 -> 3  Easy"));
  Record(out_).put({result_of("alice", 2)});
  ASSERT_EQ(run({"unset", "alice", "H2.1"}).code, 0);
  ASSERT_EQ(run({"unset", "carol", "H2", "--kind", "comment"}).code, 0);
  EXPECT_EQ(files(), before);
}

TEST_F(RecordCommands, SayWhatIsWrongInOneLine) {
  const std::map<string, string> before = files();
  expect_refused({"set", "nobody", "H2", "1", "--why", "x"}, "nobody in ");
  expect_refused({"set", "alice", "H2", "1"}, "--why");
  expect_refused({"log", "nobody"}, "nobody in ");
  expect_refused({"forget", "../alice"}, "nobody in ");
  expect_refused({"diff", "--since", "yesterday"}, "2025-03-04 10:15:00");
  EXPECT_EQ(files(), before);
  const ProgramRun elsewhere = run_hairgrade({"export", "--out", (out_ / "staff").string()});
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_FALSE(Record::is_in(out_ / "staff"));
}

}  // namespace
}  // namespace grader
