// STAFF ONLY. Tests that one hairgrade at a time writes to a folder of grades, with the same settings.
#include "grader/class_folder/folder_of_grades.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline class_folder {
namespace {

using tests::says;

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  Folder() {
    mine_.exercises = {{"S2", Role::assigned, 20}};
    mine_.suite = "suite";
    other_ = mine_;
    other_.exercises[0].points = 15;
    fs::create_directories(grades_);
  }

  std::optional<FolderOfGrades> open(const MadeBy& made_by) {
    return FolderOfGrades::open(grades_, made_by, interrupted_, said_);
  }
  void add_result(const std::string& name) const {
    SubmissionResult result;
    result.name = name;
    Record(grades_).put({result});
  }
  std::string said() const { return hair::bytes_of(said_file_); }
  std::string memory() const { return Record(grades_).made_by(); }
  // Returns the line with which the folder refuses; "" if it does not.
  std::string refusal(const MadeBy& made_by, const std::string& hand_in = "") {
    std::string line = tests::refusal<BadInput>(
        [&] { FolderOfGrades::open(grades_, made_by, interrupted_, said_, hand_in); });
    EXPECT_FALSE(says(line, "\n"));
    return line;
  }

  hair::TemporaryFolder temporary_{"folder"};
  fs::path grades_ = temporary_.path() / "of" / "grades";
  MadeBy mine_, other_;
  std::atomic<bool> interrupted_ = false;
  const fs::path said_file_ = temporary_.path() / "said";
  std::ofstream said_{said_file_};
};

TEST_F(Folder, RemembersWhatMadeItAndIsForAnybodyBeforeTheFirstResult) {
  for (const MadeBy& made_by : {mine_, other_}) {
    EXPECT_EQ(refusal(made_by), "");
    EXPECT_EQ(made_by_from_json(memory()), made_by);
  }
  EXPECT_EQ(said(), "");
}

TEST_F(Folder, WithResultsRefusesWhatWasMadeOtherwise) {
  open(mine_);
  add_result("alice");
  EXPECT_EQ(refusal(mine_), "");
  EXPECT_EQ(
      refusal(other_),
      grades_.string() +
          ": its grades were made with another course file: S2 is worth 20 points there and 15 here; use the "
          "course file that made it to add to it, --regrade to grade all of them again in place, name "
          "another folder with --out, or move this one away to "
          "grade all again");
  EXPECT_EQ(made_by_from_json(memory()), mine_);
  other_.images = false;
  EXPECT_TRUE(says(refusal(other_),
                   "15 here; pictures, and here are none; use the course file that made it and leave "
                   "out --no-images to add to it"));
}

TEST_F(Folder, OfSeveralHandInsComparesEachWithItself) {
  SubmissionResult result;
  result.name = "alice";
  FolderOfGrades::open(grades_, mine_, interrupted_, said_, "week 1")->record().put({result});
  EXPECT_EQ(refusal(other_, "week 2"), "");
  FolderOfGrades::open(grades_, other_, interrupted_, said_, "week 2")->record().put({result});
  EXPECT_EQ(refusal(mine_, "week 1") + refusal(other_, "week 2"), "");
  EXPECT_TRUE(says(refusal(other_, "week 1"), "S2 is worth 20 points there and 15 here"));
  EXPECT_TRUE(says(refusal(mine_, "week 2"), "S2 is worth 15 points there and 20 here"));
  EXPECT_TRUE(says(refusal(mine_, ""), "name one by --hand-in: \"week 1\", \"week 2\""));
}

TEST_F(Folder, ThatItMadeGoesIfItGotNoRow) {
  fs::remove(grades_);
  open(mine_);
  EXPECT_FALSE(fs::exists(grades_));
  const std::optional<FolderOfGrades> opened = open(mine_);
  add_result("alice");
  EXPECT_TRUE(fs::exists(grades_));
}

TEST_F(Folder, WithResultsThatDoNotSayHowTheyWereMadeIsRefused) {
  open(mine_);
  add_result("alice");
  Record(grades_).set_made_by("{");
  EXPECT_TRUE(says(refusal(mine_), "does not say what they were made with"));
  EXPECT_EQ(memory(), "{");
}

TEST_F(Folder, IsUsedByOneAtATime) {
  std::optional<FolderOfGrades> first = open(mine_);
  std::atomic<bool> has_it = false;
  std::jthread second([&] { has_it = open(mine_).has_value(); });
  while (said().empty() && !has_it) std::this_thread::yield();
  EXPECT_FALSE(has_it);
  first.reset();
  second.join();
  EXPECT_TRUE(has_it);
  EXPECT_EQ(said(), "hairgrade: " + grades_.string() +
                        " is in use by another hairgrade; waiting until it has finished\n")
      << "once, however long it waits";
}

TEST_F(Folder, IsCheckedOnceMoreAfterTheWait) {
  std::optional<FolderOfGrades> first = open(mine_);
  std::string refused;
  std::atomic<bool> is_over = false;
  std::jthread second([&] {
    refused = refusal(other_);
    is_over = true;
  });
  while (said().empty() && !is_over) std::this_thread::yield();
  EXPECT_FALSE(is_over);
  add_result("alice");
  first.reset();
  second.join();
  EXPECT_TRUE(says(refused, "20 points there and 15 here"));
}

TEST_F(Folder, IsNotWaitedForAfterCtrlC) {
  const std::optional<FolderOfGrades> first = open(mine_);
  interrupted_ = true;
  EXPECT_FALSE(open(mine_));
}

// `kill -9` gives the process no time for anything, and a program that it started lives on.
TEST_F(Folder, IsFreeOnceItsProcessIsKilled) {
  Pipe ready = make_pipe();
  const pid_t process = fork();
  if (process == 0) {
    setpgid(0, 0);
    try {
      const std::optional<FolderOfGrades> held = open(mine_);
      if (fork() == 0) execlp("sleep", "sleep", "infinity", nullptr);
      ready.write_end.close();
      pause();
    } catch (const BadInput&) {
    }
    _exit(1);
  }
  ready.write_end.close();
  char none;
  EXPECT_EQ(read(ready.read_end.get(), &none, 1), 0);  // its child has become `sleep`
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  EXPECT_TRUE(open(mine_));
  EXPECT_EQ(said(), "") << "it waited";
  kill(-process, SIGKILL);  // ends `sleep`
}

TEST_F(Folder, LosesWhatAKilledHairgradeHadHalfWritten) {
  open(mine_);
  add_result("alice");
  const std::vector<fs::path> half = {grades_ / ".grades.csv.12-34.part",
                                      grades_ / "alice" / ".report.html.12-34.part",
                                      grades_ / "staff" / "pictures" / ".ab.png.12-34.part"};
  for (const fs::path& file : half) write_file(file, "hal");
  open(mine_);
  for (const fs::path& file : half) EXPECT_FALSE(fs::exists(file)) << file;
  EXPECT_EQ(Record(grades_).names(), std::vector<std::string>{"alice"});
}

}  // namespace
}  // namespace grader::class_folder
