// STAFF ONLY. Tests a course's own folder from outside: it is made, each step names the next command, and
// commands in it need no options.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "grader/record/changes.h"
#include "grader/record/record.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using tests::says;

class CourseFolder : public testing::Test {
 protected:
  CourseFolder() {
    EXPECT_EQ(run_hairgrade({"new-course", folder_.string()}).code, 0);
    fs::current_path(folder_);
  }
  ~CourseFolder() override { fs::current_path(started_in_); }
  static void write(const fs::path& file, const std::string& text = "x") { std::ofstream(file) << text; }
  // Expects that `next` prints this command.
  static void expect_next(const std::string& command, const std::string& why) {
    const ProgramRun run = run_hairgrade({"next"});
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_TRUE(says(run.output, command + "\n  # ")) << run.output;
    EXPECT_TRUE(says(run.output, why)) << run.output;
  }
  static void put(const std::string& hand_in, const std::string& system = "canvas") {
    fs::create_directories("grades");
    Record record("grades", hand_in);
    record.put_people({{"alice", {"Alice Ames", "1", "a@x.de"}, system}});
    record.put({{.name = "alice", .exercises = {{.id = "H2", .points = 2, .max_points = 8}}}});
    ran(record, "2999-01-01 00:00:00");
  }

  // Downloads of an earlier time were there for the last run.
  static void ran(Record& record, const std::string& began) {
    LastRun run;
    run.graded = run.asked = run.done = 1;
    run.began = run.ended = began;
    record.set_run({}, run);
  }

  hair::TemporaryFolder temporary_{"hairgrade"};
  fs::path started_in_ = fs::current_path(), folder_ = temporary_.path() / "course";
};

TEST_F(CourseFolder, NamesTheNextCommand) {
  expect_next("hairgrade handout", "course.json is still as new-course wrote it");
  write("handout.tar.gz");
  EXPECT_TRUE(says(run_hairgrade({"next"}).output, "Nothing waits")) << "its downloads/ is empty";
  write("downloads/lab 1.zip");
  expect_next("hairgrade grade 'downloads/lab 1.zip'", "not graded");
  put("");
  fs::create_directory("grades/.slurm-1");
  expect_next("hairgrade collect", "a cluster has hand-ins that are not in the grades yet");
  fs::remove("grades/.slurm-1");
  expect_next("hairgrade gradebook canvas --fill EXPORTED.csv --out filled.csv",
              "1 hand-in: graded, and in no gradebook yet");
  EXPECT_EQ(run_hairgrade({"request", "alice", "H2", "Look again"}).code, 0) << "no --out";
  expect_next("hairgrade review", "asks for another look: 1");
  EXPECT_EQ(run_hairgrade({"answer", "1", "I did"}).code, 0);
  write("exported.csv", "Student,ID,SIS Login ID,Section,Lab (7)\n    Points Possible,,,,8\nAmes,1,aa,A,\n");
  const ProgramRun filled =
      run_hairgrade({"gradebook", "canvas", "--fill", "exported.csv", "--out", "f.csv", "--column", "7"});
  EXPECT_EQ(filled.code, 0) << filled.errors;
  expect_next("hairgrade feedback canvas 'downloads/lab 1.zip' --out feedback.zip",
              "1 hand-in: without feedback");
  Record record("grades");
  Published told = *record.published("alice");
  told.by = "feedback canvas";
  record.put_published({{"alice", told}});
  EXPECT_TRUE(says(run_hairgrade({"next"}).output, "Nothing waits"));
  EXPECT_EQ(run_hairgrade({"set", "alice", "H2", "8", "--why", "right"}).code, 0);
  expect_next("hairgrade diff --published changed.csv", "told another total than now: 1 student;");
  ran(record, "2000-01-01 00:00:00");
  expect_next("hairgrade grade 'downloads/lab 1.zip' --resume", "newer");
  write("downloads/lab 1, section b.zip");
  expect_next("hairgrade grade downloads --resume", "newer");
  ran(record, record.now());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // these times are whole seconds
  write("downloads/lab 1 (1).zip");
  expect_next("hairgrade grade 'downloads/lab 1 (1).zip' --resume", "newer");
}

TEST_F(CourseFolder, AsksForTimesAndHasFeedbackForMoodle) {
  write("course.json", R"({"exercises": {}, "hand_in": {"due": "2027-03-02 23:59"}})");
  put("", "moodle");
  expect_next("hairgrade gradebook moodle --fill EXPORTED.csv --out filled.csv",
              "nobody knows whether these are late: alice (before that grade again, with --resume --times");
  Record("grades").put_published({{"alice", {.by = "gradebook moodle", .total = 2}}});
  expect_next("hairgrade feedback moodle EXPORTED.csv --out feedback.zip", "1 hand-in: without feedback");
}

TEST_F(CourseFolder, AsksNobodyAboutPointsThatAPersonHasSet) {
  put("");
  Record("grades").put(
      {.result = {.name = "alice",
                  .exercises = {{.id = "H2", .status = Status::broke_rules, .max_points = 8}}}});
  expect_next("hairgrade review", "broke the rules: 1");
  EXPECT_EQ(run_hairgrade({"set", "alice", "H2", "2", "--why", "by hand"}).code, 0);
  expect_next("hairgrade gradebook canvas --fill EXPORTED.csv --out filled.csv",
              "1 hand-in: graded, and in no gradebook yet");
}

TEST_F(CourseFolder, KnowsSeveralHandInsByTheirDownloads) {
  write("course.json", R"({"exercises": {}, "hand_ins": {
    "week 1": {"exercises": ["S1"], "due": "2027-03-02 23:59"},  // comments may stand here
    "week 2": {"exercises": ["H1"], "due": "2027-03-09 23:59"}}})");
  write("handout.tar.gz");
  write("downloads/week 2.5.zip");
  EXPECT_TRUE(says(run_hairgrade({"next"}).output, "downloads/, named after its hand-in"));
  write("downloads/week 2 (1).zip");
  expect_next("hairgrade grade 'downloads/week 2 (1).zip' --hand-in 'week 2'", "not graded");
}

TEST_F(CourseFolder, IsRefusedElsewhere) {
  fs::current_path(temporary_.path());
  EXPECT_EQ(run_hairgrade({"next"}).code, 2);
  EXPECT_EQ(run_hairgrade({"log", "alice"}).code, 2) << "without --out";
  EXPECT_EQ(run_hairgrade({"new-course", folder_.string()}).code, 2) << "it is there already";
}

}  // namespace
}  // namespace grader
